"""VDMA LIF, read."""

import json
from typing import Any

import pytest

from fleet_tui.model.graphs.document import GraphFormat, Motion
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import SHARED, read_text, write_text

F = GraphFormat.LIF


def lif(*nodes: Any, edges: Any = (), stations: Any = (), **more: Any) -> str:
    layout = {"layoutId": "L", "layoutVersion": "1", "nodes": nodes, "edges": edges, "stations": stations}
    return json.dumps({"metaInformation": {"projectIdentification": "p"}, "layouts": [layout], **more})


def node(id_: str, x: float | str, y: float | str, *types: Any, **more: Any) -> Any:
    return {"nodeId": id_, "nodePosition": {"x": x, "y": y}, "vehicleTypeNodeProperties": types, **more}


def edge(id_: str, start: str, end: str, *types: Any) -> Any:
    ends = {"edgeId": id_, "startNodeId": start, "endNodeId": end}
    return {**ends, "vehicleTypeEdgeProperties": types}


A, B = {"vehicleTypeId": "a", "theta": 1.0}, {"vehicleTypeId": "b", "theta": 2.0}


def test_values_of_the_chosen_vehicle_type() -> None:
    text = lif(
        node("n1", 0, 0, A, B),
        node("n2", 1, 0, A),
        edges=[
            edge("e1", "n1", "n2", {"vehicleTypeId": "a", "maxSpeed": 1.0, "vehicleOrientation": 180.0}),
            edge("e2", "n2", "n1", {"vehicleTypeId": "a", "maxSpeed": 1.0, "vehicleOrientation": 180.0}),
        ],
    )
    floor = read_text(text).document.floors["L"]
    assert [one.heading for one in floor.vertices.values()] == [None, 1.0]
    assert [(one.speed, one.motion, one.two_way) for one in floor.edges.values()] == [
        (1.0, Motion.BACKWARD, True)
    ]
    assert floor.edges["e1"].reverse_id == "e2"
    chosen = read_text(text, vehicle_type="b").document.floors["L"]
    assert [one.heading for one in chosen.vertices.values()] == [2.0, None]
    with pytest.raises(GraphError, match="no vehicle type 'c' in the file: it has a, b"):
        read_text(text, vehicle_type="c")


def test_a_null_for_the_values_of_vehicle_types_is_none_of_them() -> None:
    bare = node("n1", 0, 0) | {"vehicleTypeNodeProperties": None}
    (floor,) = read_text(lif(bare, node("n2", 1, 0))).document.floors.values()
    assert floor.vertices["n1"].heading is None


def test_labels_types_and_curves() -> None:
    charge = {"vehicleTypeId": "a", "actions": [{"actionType": "startCharging", "required": True}]}
    points = [{"x": 0, "y": 0}, {"x": 0.5, "y": 1.0}, {"x": 1, "y": 0}]
    curve = {"vehicleTypeId": "a", "trajectory": {"degree": 2, "controlPoints": points}}
    stations = [
        {"stationId": "s1", "interactionNodeIds": ["n2"], "stationName": "Dock", "stationHeight": 1.5},
        {
            "stationId": "s2",
            "interactionNodeIds": ["n1", "n2"],
            "stationPosition": {"x": 1, "y": 2, "theta": 3},
        },
    ]
    text = lif(
        node("n1", 0, 0, charge, nodeName="007"),
        node("n2", 1, 0),
        edges=[edge("e", "n1", "n2", curve)],
        stations=stations,
    )
    document = read_text(text).document
    floor = document.floors["L"]
    assert [(one.label, one.type) for one in floor.vertices.values()] == [("007", "charger"), ("Dock", "")]
    assert floor.edges["e"].control_points == ((0.5, 1.0),)
    assert [(one.name, one.height, one.yaw) for one in document.stations] == [
        ("Dock", 1.5, None),
        ("s2", None, 3.0),
    ]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (lif(7), "layout L nodes element 0: 7 instead of a mapping"),
        (lif({"nodeId": "a"}), "layout L node a: no nodePosition"),
        (lif({"nodeId": ""}), "nodes element 0 nodeId: empty id"),
        (lif(node("a", None, 0)), "node a x: nothing instead of a number"),  # type: ignore[arg-type]  # on purpose
        (lif(node("a", 0, 0, 7)), "node a vehicleTypeNodeProperties: 7 instead of a mapping"),
        (lif(node("a", 0, 0, {"actions": [7]})), "node a actions: 7 instead of a mapping"),
        (lif(node("a", 0, 0), edges=[edge("e", "a", "a", {})]), "layout L edge e: no vehicleTypeId"),
        (lif(edges=[edge("e", "a", "a", A, A)]), "edge e: a vehicle type is listed twice"),
        (lif(edges=[{"edgeId": "e", "startNodeId": "a"}]), "edge e: no endNodeId"),
        (lif(stations=[{"stationName": "x"}]), "layout L station: no stationId"),
        (json.dumps({"layouts": [{}]}), "layouts\\[0\\]: no layoutId"),
        (json.dumps({"layouts": [{"layoutId": "a"}] * 2}), "layoutId 'a' twice"),
    ],
)
def test_faults_are_named(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(text)


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
def test_nothing_of_the_sample_is_lost() -> None:
    text = (SHARED / "graphs" / "example.lif.json").read_text()
    for vehicle in ("", "vehicle-001"):
        document = read_text(text, vehicle_type=vehicle).document
        assert json.loads(write_text(document, F)) == json.loads(text)


def test_numbers_may_be_written_as_text_and_a_blank_is_none() -> None:
    station = {"stationId": "s", "stationName": "S", "interactionNodeIds": ["n1"], "stationHeight": " "}
    text = lif(
        node("n1", "0.5", "2000000"),
        node("n2", 1, 0, {"vehicleTypeId": "a", "theta": "1.57"}, {"vehicleTypeId": "b", "theta": ""}),
        stations=[station],
    )
    found = read_text(text, lengths="mm")
    floor = found.document.floors["L"]
    assert (floor.vertices["n1"].x, floor.vertices["n1"].y) == (0.0005, 2000.0)
    assert floor.vertices["n2"].heading == 1.57 and found.document.stations[0].height is None


def test_layouts_of_version_2_are_read_by_the_words_of_version_1() -> None:
    one = {"nodeId": "n", "nodePosition": {"x": 1, "y": 2}}
    typed = {**one, "mobileRobotTypeNodeProperties": [{"mobileRobotTypeId": "agv", "theta": 1.0}]}
    layout = {"layoutId": "L", "nodes": [typed], "edges": [], "stations": []}
    found = read_text(
        json.dumps({"metaInformation": {}, "origins": [{"originId": "o", "layouts": [layout]}]})
    )
    assert found.format is F
    assert found.document.floors["L"].vertices["n"].heading == 1.0
