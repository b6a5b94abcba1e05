"""Route graphs from files: what is read of them, and what a file that is wrong costs."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.maps import route_graphs
from fleet_tui.maps.formats.graph_file import ReadChoices
from fleet_tui.maps.formats.reading import read_graph
from fleet_tui.maps.route_graphs import load_floor_graph
from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.graph import Edge, Role, RouteGraph
from fleet_tui.model.graphs.live import floor_of

SHARED = Path(__file__).parents[3] / "shared"
SAMPLES = {"graphs/sample_graph.geojson": (9, 12), "maps/depot/depot_graph.geojson": (34, 39)}
HUGE = 123456789
"""Stands for a number of 5000 digits, which Python would not write."""

Feature = dict[str, Any]


def node(id_: object, x: object = 0.0, y: object = 0.0, **metadata: object) -> Feature:
    properties = {"id": id_, "frame": "map", "metadata": metadata}
    return {"type": "Feature", "properties": properties, "geometry": {"type": "Point", "coordinates": [x, y]}}


def edge(id_: int, start: object, end: object, type_: str = "MultiLineString") -> Feature:
    properties = {"id": id_, "startid": start, "endid": end, "cost": 10.0}
    return {"type": "Feature", "properties": properties, "geometry": {"type": type_}}


def collection(*features: object) -> str:
    return json.dumps({"type": "FeatureCollection", "name": "graph", "features": features})


@pytest.fixture
def read(tmp_path: Path) -> Any:
    def loaded(content: str | bytes) -> FloorGraphLoaded:
        path = tmp_path / "g.geojson"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return load_floor_graph("floor_0", path)

    return loaded


def test_vertices_edges_labels_and_classes(read: Any) -> None:
    loaded = read(
        collection(
            node(3, 1.0, 2, name="Base", **{"class": "charger"}),
            node(1, 0.5, -1.0, name=7, **{"class": "lift"}),
            node(2, 0, 0, name="  ", region={"x_values": [1.0]}, **{"class": "shelf"}),
            edge(10, 3, 1),
            edge(11, 1, 3),
            edge(12, 2, 1, "LineString"),
            edge(13, 1, 2),
        )
    )
    assert (loaded.floor, loaded.problem) == ("floor_0", "")
    assert loaded.labels == {"3": "Base", "1": "7"}
    graph = loaded.graph
    assert [(one.id, one.x, one.y, one.role, one.type) for one in graph.vertices.values()] == [
        ("3", 1.0, 2.0, Role.DOCKING, "charger"),
        ("1", 0.5, -1.0, Role.ELEVATOR, "lift"),
        ("2", 0.0, 0.0, Role.PLAIN, "shelf"),
    ]
    assert graph.edges == (Edge("10", "3", "1", "11"), Edge("12", "2", "1", "13")) and not graph.directed
    assert graph.path("3", "2") == ("3", "1", "2")


def test_one_edge_without_its_opposite_and_all_go_one_way(read: Any) -> None:
    graph = read(collection(node(0), node(1), node(2), edge(3, 0, 1), edge(4, 1, 0), edge(5, 1, 2))).graph
    assert graph.directed and len(graph.edges) == 3
    assert graph.path("0", "2") == ("0", "1", "2") and graph.path("2", "0") == ()


def test_edges_may_share_an_id_and_none_is_lost(read: Any) -> None:
    loaded = read(collection(node(0), node(1), node(2), edge(9, 0, 1), edge(9, 1, 2)))
    assert len(loaded.graph.edges) == 2 and loaded.problem == ""


@pytest.mark.parametrize(
    ("feature", "problem"),
    [
        (node(0, 5.0, name="Other"), "vertex 0 duplicated: the last one is used"),
        (edge(7, 1, 0), "duplicate edge from 1 to 0: the last one is used"),
        (edge(7, 0, 42), "edge 7 names unknown vertex 42: left out"),
        (edge(7, 0, None), "edge 7 has no startid or no endid: left out"),
        (node(7, 1e12), "vertex 7: (1e+12, 0) m is out of range: left out"),
        (node(7, None), "vertex 7: coordinates must be [x, y]: Expected `float`, got `null`"),
        (node(7, [1]), "vertex 7: coordinates must be [x, y]: Expected `float`, got `array`"),
        (node("a"), "features[4]: Expected `int`, got `str` - at `$.properties.id`"),
        (node(-1), "features[4]: Expected `int` >= 0 - at `$.properties.id`"),
        (node(2**32), "features[4]: Expected `int` <= 4294967295 - at `$.properties.id`"),
        (node(HUGE), "features[4]: "),
        (7, "features[4]: Expected `object`, got `int`"),
        ({"properties": {"id": 8}}, "features[4]: Object missing required field `geometry`"),
        (
            {"properties": {"id": 8}, "geometry": {"type": "Polygon"}},
            "features[4]: geometry 'Polygon' is neither a Point nor a line: left out",
        ),
    ],
)
def test_what_is_wrong_costs_no_other(read: Any, feature: object, problem: str) -> None:
    text = collection(node(0, name="Base"), node(1), edge(5, 0, 1), edge(6, 1, 0), feature)
    loaded = read(text.replace(f'"id": {HUGE}', f'"id": {"9" * 5000}'))
    assert loaded.problem.startswith(f"graph g.geojson: {problem}") and "more faults" not in loaded.problem
    assert set(loaded.graph.vertices) == {"0", "1"} and len(loaded.graph.edges) == 1
    twice = feature == node(0, 5.0, name="Other")
    assert loaded.labels == {"0": "Other" if twice else "Base"}
    assert loaded.graph.vertices["0"].x == (5.0 if twice else 0.0)


def test_many_faults_are_counted(read: Any) -> None:
    loaded = read(collection(node(0), *(edge(n, 0, 9) for n in range(5))))
    assert loaded.problem == "graph g.geojson: edge 0 names unknown vertex 9: left out, 4 more faults"


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("", "empty; known formats: native, oh, rmf, "),
        ("levels:\n  L1: {}\n", "has no vertices"),
        ('{"type":\n\n"FeatureCollection",\n "features": [NaN]}', "not JSON: invalid character in line 4"),
        ("<model/>", "plant model '': save it with openTCS 6 or 7"),
        ("[]", "no known format; known formats: native, oh, rmf, "),
        ('{"layouts": []}', "has the floors none: none is called floor_0"),
        ('{"type": "FeatureCollection"}', "has no vertices"),
        ('{"type": "FeatureCollection", "features": {}}', "features: a mapping instead of a list"),
        ('{"type": "FeatureCollection", "features": []}', "has no vertices: expected features with"),
        ('{"type": "FeatureCollection", "features": [{}]}', "has no vertices: features[0]: Object missing"),
        (b'{"type": "\xff"}', "unreadable: 'utf-8'"),
        ("[" * 200_000, "nested too deep"),
        ('{"type": "FeatureCollection", "features": [' + '{"a":' * 200_000, "nested too deep"),
    ],
)
def test_a_file_that_is_no_graph(read: Any, content: str | bytes, problem: str) -> None:
    loaded = read(content)
    assert loaded.graph is None and loaded.labels == {}
    assert loaded.problem.startswith(f"graph g.geojson: {problem}"), loaded.problem


def test_files_that_are_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert load_floor_graph("f", tmp_path / "gone.json").problem == "graph gone.json: no such file"
    assert "not a regular file" in load_floor_graph("f", Path("/dev/zero")).problem
    assert "unreadable" in load_floor_graph("f", tmp_path).problem
    monkeypatch.setattr(route_graphs, "MAX_FILE", 10)
    (tmp_path / "large").write_text(collection(node(0)))
    assert load_floor_graph("f", tmp_path / "large").problem == "graph large: unreadable: over 10 bytes"


def test_more_than_is_taken_is_said(read: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(route_graphs, "MOST_VERTICES", 3)
    monkeypatch.setattr(route_graphs, "MOST_EDGES", 2)
    loaded = read(collection(*map(node, range(4))))
    assert loaded.problem == "graph g.geojson: 4 vertices: only the first 3 used"
    assert list(loaded.graph.vertices) == ["0", "1", "2"]
    loaded = read(collection(node(0), node(1), edge(3, 0, 1), edge(4, 1, 0), edge(5, 0, 0)))
    assert "3 edges: only the first 2 used" in loaded.problem and len(loaded.graph.edges) == 1


def test_long_labels_are_cut(read: Any) -> None:
    loaded = read(collection(node(0, name="x" * 10_000, **{"class": "y" * 10_000})))
    assert len(loaded.labels["0"]) < 300 and len(loaded.graph.vertices["0"].type) < 300


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=4),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=3),
    max_leaves=6,
)
IDS = st.integers(0, 4) | JSON
PARTS = (
    JSON
    | st.builds(node, IDS, JSON | st.floats(), st.floats(), name=JSON)
    | st.builds(edge, st.integers(0, 9), IDS, IDS)
)


@given(st.lists(PARTS, max_size=12))
def test_whatever_the_features_are_the_graph_holds_together(
    tmp_path_factory: pytest.TempPathFactory, features: list[object]
) -> None:
    path = tmp_path_factory.getbasetemp() / "any.geojson"
    path.write_text(collection(*features), encoding="utf-8", errors="surrogatepass")
    loaded = load_floor_graph("f", path)
    assert loaded.graph is not None or loaded.problem
    graph = loaded.graph or RouteGraph()
    assert set(loaded.labels) <= set(graph.vertices)
    assert all({one.start, one.end} <= set(graph.vertices) for one in graph.edges)


@pytest.mark.skipif(
    not (SHARED / "graphs").is_dir(), reason="the samples lie beside the repository only where it was built"
)
@pytest.mark.parametrize("name", SAMPLES)
def test_files_of_real_sites(name: str) -> None:
    loaded = load_floor_graph("f", SHARED / name)
    assert loaded.graph is not None and loaded.problem == ""
    assert (len(loaded.graph.vertices), len(loaded.graph.edges)) == SAMPLES[name]
    start, *_, end = loaded.graph.vertices
    assert loaded.graph.path(start, end)


@pytest.mark.skipif(
    not (SHARED / "graphs").is_dir(), reason="the samples lie beside the repository only where it was built"
)
@pytest.mark.parametrize(("name", "vertices"), [("office_nav.yaml", 24), ("opentcs7.sample.xml", 15)])
def test_other_formats_of_real_sites(name: str, vertices: int) -> None:
    loaded = load_floor_graph("f", SHARED / "graphs" / name)
    assert loaded.problem == "" and loaded.graph is not None
    assert len(loaded.graph.vertices) == vertices and loaded.labels


def test_edges_with_one_id_get_the_ids_that_a_graph_editor_gives(read: Any) -> None:
    places = [node(n, float(n), 0.0) for n in range(3)]
    for ways in (((0, 1), (1, 0), (1, 2), (2, 1)), ((0, 1), (1, 0), (1, 2))):
        text = collection(*places, *(edge(7 + n % 2, *way) for n, way in enumerate(ways)))
        (floor,) = read_graph(text, None, ReadChoices()).document.floors.values()
        live = floor_of("floor_0", read(text).graph, {})
        assert {id_: (one.start, one.end, one.reverse_id) for id_, one in live.edges.items()} == {
            id_: (one.start, one.end, one.reverse_id) for id_, one in floor.edges.items()
        }
