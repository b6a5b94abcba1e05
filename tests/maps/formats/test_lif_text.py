"""VDMA LIF, written, and a checker of the format's own rules."""

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.maps.formats.graph_file import MissingChoiceError, WriteChoices
from fleet_tui.maps.formats.writing import write_graph
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphDocument, GraphFormat, Motion
from tests.support.graph_files import NUMBERS, TABLES, again, documents, read_text, sample, write_text

F = GraphFormat.LIF
META = {"projectIdentification", "creator", "exportTimestamp", "lifVersion"}


def check(text: str) -> dict[str, Any]:
    """The rules of the schema, and of names in one space for all layouts."""
    found: dict[str, Any] = json.loads(text)
    assert found["metaInformation"].keys() >= META
    ids = dict[str, list[str]]()
    for layout in found["layouts"]:
        assert layout.keys() >= {"layoutId", "layoutVersion", "nodes", "edges", "stations"}
        nodes = {node["nodeId"] for node in layout["nodes"]}
        for node in layout["nodes"]:
            assert all(type(node["nodePosition"][axis]) is float for axis in "xy")
            assert node["vehicleTypeNodeProperties"]
            assert all(one["vehicleTypeId"] for one in node["vehicleTypeNodeProperties"])
        for edge in layout["edges"]:
            assert {edge["startNodeId"], edge["endNodeId"]} <= nodes
            assert all("vehicleTypeId" in one for one in edge["vehicleTypeEdgeProperties"])
            for one in edge["vehicleTypeEdgeProperties"]:
                curve = one.get("trajectory")
                if curve and "knotVector" in curve:
                    assert len(curve["knotVector"]) == len(curve["controlPoints"]) + curve["degree"] + 1
        for station in layout["stations"]:
            assert set(station["interactionNodeIds"]) <= nodes
        for kind, key in (("nodes", "nodeId"), ("edges", "edgeId"), ("stations", "stationId")):
            ids.setdefault(key, []).extend(one[key] for one in layout[kind])
    assert all(len(set(ids[key])) == len(ids[key]) for key in ("nodeId", "edgeId") if key in ids)
    return found


@given(st.lists(st.tuples(NUMBERS, NUMBERS, TABLES, TABLES), min_size=2, max_size=3), TABLES, TABLES)
def test_nothing_of_a_file_is_lost(places: list[Any], of_edge: Any, of_file: Any) -> None:
    nodes = [
        {
            "nodeId": f"n{n}",
            "nodePosition": {"x": x, "y": y},
            "vehicleTypeNodeProperties": [
                {"vehicleTypeId": "a", "theta": 0.5, **data},
                {"vehicleTypeId": "b"},
            ],
            **more,
        }
        for n, (x, y, more, data) in enumerate(places)
    ]
    types = [{"vehicleTypeId": "a", "maxSpeed": 2.0, **of_edge}, {"vehicleTypeId": "b", "maxSpeed": 1.0}]
    edges = [
        {"edgeId": f"e{n}", "startNodeId": a, "endNodeId": b, "vehicleTypeEdgeProperties": types, **of_edge}
        for n, (a, b) in enumerate((("n0", "n1"), ("n1", "n0"), ("n0", "n1")))
    ]
    station = {
        "stationId": "s",
        "interactionNodeIds": ["n0"],
        "stationPosition": {"x": 1.0, "y": 2.0},
        **of_edge,
    }
    layout = {
        "layoutId": "L",
        "layoutVersion": "3",
        "nodes": nodes,
        "edges": edges,
        "stations": [station],
        **of_file,
    }
    meta = dict.fromkeys(sorted(META), "x")
    tree = {"metaInformation": meta, "layouts": [layout], **of_file}
    written = check(write_text(read_text(json.dumps(tree)).document, F))
    for one in (layout, written["layouts"][0]):
        one["edges"] = sorted(one["edges"], key=lambda edge: edge["edgeId"])
    assert written == tree


def test_what_we_draw_is_read_again() -> None:
    found = again(sample(), F)
    floor, was = found.floors["ground"], sample().floors["ground"]
    assert floor.labels == was.labels
    assert (floor.vertices["0"].heading, floor.vertices["0"].type) == (1.5, "charger")
    assert (floor.edges["10"].two_way, floor.edges["10"].speed) == (True, 0.5)
    assert floor.edges["12"].motion is Motion.BACKWARD
    assert floor.edges["13"].control_points == ((3.0, 3.5),)
    assert found.stations[0].stops == (("ground", "0"),)
    check(write_text(sample(), F))


def test_a_vehicle_type_is_needed_unless_the_file_has_them() -> None:
    with pytest.raises(MissingChoiceError) as missing:
        write_graph(sample(), F, WriteChoices())
    assert missing.value.option == "--vehicle-type"
    assert check(write_graph(again(sample(), F), F, WriteChoices()))


def test_edits_reach_every_vehicle_type() -> None:
    document = again(sample(), F)
    floor = document.floors["ground"]
    vertex, edge = (
        replace(floor.vertices["0"], heading=0.25, label="New"),
        replace(floor.edges["10"], speed=0.75),
    )
    floor = replace(floor, vertices={**floor.vertices, "0": vertex}, edges={**floor.edges, "10": edge})
    floor = again(document.with_floor(floor), F).floors["ground"]
    assert (floor.vertices["0"].heading, floor.vertices["0"].label, floor.edges["10"].speed) == (
        0.25,
        "New",
        0.75,
    )


def test_ids_are_unique_over_all_layouts() -> None:
    other = DocumentFloor("upper", {"0": DocumentVertex("0", 0.0, 0.0), "9": DocumentVertex("9", 0.0, 0.0)})
    found = check(write_text(sample().with_floor(other), F))
    assert [one["nodeId"] for one in found["layouts"][1]["nodes"]] == ["upper-0", "9"]
    assert found["layouts"][0]["stations"][0]["interactionNodeIds"] == ["ground-0"]


def test_curves_of_openTCS() -> None:  # noqa: N802  # the name of the program
    points = tuple((float(n), 1.0) for n in range(5))
    floor = sample().floors["ground"]
    for kind, degree in (("BEZIER_3", 3), ("POLYPATH", 1), ("BEZIER", 6)):
        edge = replace(floor.edges["13"], control_points=points, extra={"opentcs": {"connectionType": kind}})
        layout = check(write_text(GraphDocument("x", {"ground": replace(floor, edges={"13": edge})}), F))[
            "layouts"
        ][0]
        assert layout["edges"][0]["vehicleTypeEdgeProperties"][0]["trajectory"]["degree"] == degree


@given(documents())
def test_whatever_is_written_keeps_the_rules(document: GraphDocument) -> None:
    check(write_text(document, F))
