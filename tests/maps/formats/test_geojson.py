"""Route graphs of Nav2, and a checker of the format's own rules."""

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.maps.formats.losses import losses
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat, Motion, of_floor
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import NUMBERS, SHARED, TABLES, again, documents, read_text, sample, write_text

F = GraphFormat.GEOJSON
Feature = dict[str, Any]


def check(text: str) -> dict[str, Any]:
    """The rules of Nav2's route server for a file."""
    found: dict[str, Any] = json.loads(text)
    assert found["type"] == "FeatureCollection"
    ids = [one["properties"]["id"] for one in found["features"]]
    assert len(set(ids)) == len(ids) and all(type(id_) is int and id_ >= 0 for id_ in ids)
    nodes = [one for one in found["features"] if one["geometry"]["type"] == "Point"]
    edges = [one for one in found["features"] if one["geometry"]["type"] in ("LineString", "MultiLineString")]
    assert len(nodes) + len(edges) == len(ids)
    places = {one["properties"]["id"] for one in nodes}
    for one in nodes:
        assert one["properties"]["frame"] and all(type(n) is float for n in one["geometry"]["coordinates"])
    for one in edges:
        properties = one["properties"]
        assert {properties["startid"], properties["endid"]} <= places
        assert type(properties.get("cost", 1.0)) is float
        assert type(properties.get("metadata", {}).get("abs_speed_limit", 1.0)) is float
        assert one["geometry"]["coordinates"]
    return found


def node(id_: int, x: Any, y: Any, **properties: Any) -> Feature:
    point = {"type": "Point", "coordinates": [x, y]}
    return {"type": "Feature", "properties": {"id": id_, "frame": "map", **properties}, "geometry": point}


def line(id_: int, start: Any, end: Any, *points: list[float], **properties: Any) -> Feature:
    geometry = {"type": "LineString", "coordinates": list(points)}
    ends = {"id": id_, "startid": start, "endid": end}
    return {"type": "Feature", "properties": {**ends, **properties}, "geometry": geometry}


def collection(*features: Feature, **more: Any) -> str:
    return json.dumps({"type": "FeatureCollection", "name": "g", "features": features, **more})


def by_id(text: str) -> dict[int, Feature]:
    return {one["properties"]["id"]: one for one in json.loads(text)["features"]}


PLACES = st.lists(st.tuples(NUMBERS, NUMBERS, TABLES, TABLES), min_size=2, max_size=4)


def is_a_floor(places: list[Any]) -> bool:
    """One of some centimetres would be one of degrees."""
    return any(max(axis) - min(axis) > 1.0 for axis in list(zip(*places, strict=True))[:2])


@given(PLACES.filter(is_a_floor), TABLES, TABLES)
def test_nothing_of_a_file_is_lost(places: list[Any], of_edge: Feature, of_file: Feature) -> None:
    nodes = [node(n, x, y, **more, metadata=data) for n, (x, y, more, data) in enumerate(places)]
    ends = [list(map(float, places[n][:2])) for n in (0, 1)]
    edges = [
        line(70, 0, 1, *ends, cost=3.0, metadata={"abs_speed_limit": 0.5, **of_edge}),
        line(71, 1, 0, *ends[::-1], cost=3.0, metadata={"abs_speed_limit": 0.5, **of_edge}),
        line(72, 0, 1, ends[0], [9.0, 9.5], ends[1], operations={"stop": of_edge}, **of_edge),
    ]
    text = collection(*nodes, *edges, **of_file)
    written = write_text(read_text(text).document, F)
    check(written)
    for one in nodes:
        if not one["properties"]["metadata"]:
            one["properties"].pop("metadata")
    assert by_id(written) == {one["properties"]["id"]: one for one in [*nodes, *edges]}
    top = json.loads(written)
    assert {key: top[key] for key in of_file} == of_file
    assert again(read_text(text, floor="f").document, F) == read_text(text, floor="f").document


def test_what_we_add_is_read_again() -> None:
    floor = again(sample(), F).floors["ground"]
    was = sample().floors["ground"]
    assert floor.labels == was.labels and floor.frame_id == "map"
    assert [one.type for one in floor.vertices.values()] == ["charger", "", "lift", "shelf"]
    assert (floor.edges["10"].reverse_id, floor.edges["10"].speed, floor.edges["10"].cost) == ("11", 0.5, 2.0)
    assert (floor.edges["12"].motion, floor.edges["12"].two_way) == (Motion.BACKWARD, False)
    assert floor.edges["13"].locked and floor.edges["13"].length == 3.5
    check(write_text(sample(), F))


def test_ids_are_of_one_counter_and_whole_numbers() -> None:
    text = collection(node(0, 0, 0), node(1, 1, 0), line(1, 0, 1), line(1, 1, 0, cost=2.0))
    floor = read_text(text, floor="f").document.floors["f"]
    assert sorted(floor.edges) == ["1", "2"] and floor.edges["2"].repeats == ("1",)
    assert len(check(write_text(of_floor(floor), F))["features"]) == 4
    named = DocumentFloor("f", {"node-1": DocumentVertex("node-1", 0.0, 0.0)})
    assert again(of_floor(named), F).floors["f"].vertices["0"].source_id == "node-1"


def test_of_duplicate_nodes_the_later_keeps_the_id() -> None:
    floor = read_text(collection(node(3, 0, 0), node(3, 5, 0)), floor="f").document.floors["f"]
    assert {id_: (one.x, one.repeats) for id_, one in floor.vertices.items()} == {
        "4": (0.0, ("3",)),
        "3": (5.0, ()),
    }


def test_a_file_without_duplicates_is_written_of_one_that_has_them() -> None:
    repeated = line(9, 0, 1), line(9, 1, 0), line(10, 0, 20), line(10, 20, 0)
    document = read_text(collection(node(0, 0, 0), node(1, 1, 0), node(20, 2, 0), *repeated)).document
    assert [str(one) for one in losses(document, F)] == ["edge ids: 2"]
    (floor,) = document.floors.values()
    assert {id_: (edge.reverse_id, edge.repeats) for id_, edge in floor.edges.items()} == {
        "21": ("9", ("9",)),
        "22": ("10", ("10",)),
    }  # the last keeps the id; new ones are no vertex's
    text = write_text(document, F)
    mended = read_text(text).document
    (floor,) = mended.floors.values()
    assert not any(one.repeats or one.source_id for one in floor.edges.values())
    assert losses(mended, F) == () and write_text(mended, F) == text


def test_what_is_no_text_stays_in_the_metadata() -> None:
    text = collection(node(0, 0, 0, metadata={"name": ["a"], "class": True}), node(1, 0, 0, metadata=7))
    document = read_text(text, floor="f").document
    assert document.floors["f"].labels == {}
    assert {n: by_id(write_text(document, F))[n]["properties"]["metadata"] for n in (0, 1)} == {
        0: {"name": ["a"], "class": True},
        1: 7,
    }


@given(documents())
def test_whatever_is_written_keeps_the_rules(document: Any) -> None:
    floor = next(iter(document.floors.values()))
    found = check(write_text(of_floor(floor), F))
    ways = sum(1 + edge.two_way for edge in floor.edges.values())
    assert len(found["features"]) == len(floor.vertices) + ways


@pytest.mark.parametrize(
    ("feature", "problem"),
    [
        (7, "features\\[1\\]: 7 instead of a mapping"),
        ({"geometry": {"type": "Point"}}, "features\\[1\\] properties: nothing instead of a mapping"),
        ({"properties": {}, "geometry": 7}, "features\\[1\\] geometry: 7 instead"),
        (node(-1, 0, 0), "vertex 1 of the file id: -1 instead of a whole number from 0 on"),
        (node(True, 0, 0), "id: True instead of a whole number"),
        (node(8, "a", 0), "vertex 8 coordinates: 'a' instead of a number"),
        (
            {**node(8, 0, 0), "geometry": {"type": "Point", "coordinates": [1]}},
            "vertex 8: coordinates must be",
        ),
        (line(8, 0, None), "edge 8 endid: None instead of a whole number"),
        ({**line(8, 0, 0), "properties": {"id": 8}}, "edge 8: no startid"),
        (node(9, 0, 0, metadata={"name": "x" * 5000}), "name: a text of 5,000 characters, at most 1,000"),
    ],
)
def test_faults_are_named(feature: Any, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(collection(node(0, 0, 0), feature))


def test_other_features_are_counted() -> None:
    polygon = {"type": "Feature", "properties": {"id": 4}, "geometry": {"type": "Polygon"}}
    assert read_text(collection(node(0, 0, 0), polygon)).left_out == {"other features": 1}


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
def test_the_sample_of_nav2() -> None:
    text = (SHARED / "graphs" / "sample_graph.geojson").read_text()
    before, after = by_id(text), by_id(write_text(read_text(text).document, F))
    check(write_text(read_text(text).document, F))
    for id_, feature in before.items():
        if feature["geometry"]["type"] == "Point":
            assert after[id_] == feature
        else:
            assert after[id_]["properties"] == feature["properties"]


def test_ids_may_be_of_the_feature_or_written_with_a_point_and_an_edge_may_have_no_line() -> None:
    one, other = node(1, 0, 0), node(2, 5, 0)
    one["id"] = one["properties"].pop("id")
    other["properties"]["id"] = 2.0
    edge = {"type": "Feature", "properties": {"id": 3, "startid": 1, "endid": 2}, "geometry": None}
    floor = read_text(collection(one, other, edge)).document.floors["floor"]
    assert [*floor.vertices] == ["1", "2"] and [*floor.edges] == ["3"]


@pytest.mark.parametrize(
    ("more", "size"), [({}, 1e-3), ({"crs": {"properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}}, 0.5)]
)
def test_degrees_are_refused_not_read_as_metres(more: Feature, size: float) -> None:
    with pytest.raises(GraphError, match="coordinates of degrees, not metres"):
        read_text(collection(node(1, 13.4, 52.52), node(2, 13.4 + size, 52.52), **more))
    assert read_text(collection(node(1, 13.4, 52.52), node(2, 18.4, 52.52), **more))


def test_a_building_in_degrees_is_named() -> None:
    feature = {"feature_type": "rmf_vertex", **node(1, 13.4, 52.5)}
    with pytest.raises(GraphError, match="a building of Open-RMF in degrees"):
        read_text(collection(feature))
