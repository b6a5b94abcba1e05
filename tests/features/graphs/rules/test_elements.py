"""Lint of single vertices and edges."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.features.graphs.rules.elements import ELEMENT_RULES
from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.graph import RouteGraph, Vertex
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex, GraphFormat
from fleet_tui.model.grid import OccupancyGrid


def vertex(id_: str, label: str = "", type_: str = "", x: float = 0.0, *repeats: str) -> DocumentVertex:
    return DocumentVertex(id_, x, 0.0, label, type_, repeats=repeats)


def found(*parts: DocumentVertex | DocumentEdge, **facts: object) -> list[tuple[str, bool]]:
    vertices = {one.id: one for one in parts if isinstance(one, DocumentVertex)}
    edges = {one.id: one for one in parts if isinstance(one, DocumentEdge)}
    floor, inputs = DocumentFloor("f", vertices, edges), LintInputs(**facts)  # type: ignore[arg-type]  # by name
    return [(one.text, one.is_error) for rule in ELEMENT_RULES for one in rule(floor, inputs)]


ENDS = (vertex("1"), vertex("2"))


@pytest.mark.parametrize(
    ("parts", "text"),
    [
        ([vertex("4", "", "", 0.0, "3"), vertex("3")], "vertex 3: duplicate id"),
        ([vertex("2147483648")], "vertex 2147483648: id outside int32"),
        ([vertex("9" * 40)], f"vertex {'9' * 40}: id outside int32"),
        ([vertex("1"), DocumentEdge("5", "1", "9")], "edge 5: unknown vertex 9"),
        ([vertex("1"), DocumentEdge("5", "1", "1")], "edge 5: leads from 1 to itself"),
        ([vertex("1", x=math.nan)], "vertex 1: (nan, 0) m is not a place on a floor"),
        ([vertex("1", x=1e12)], "vertex 1: (1e+12, 0) m is not a place on a floor"),
        (
            [vertex("1"), replace(vertex("2", "A"), heading=math.nan)],
            "vertex 2 (A): heading nan is not an angle",
        ),
        ([*ENDS, DocumentEdge("5", "1", "2", speed=-1.0)], "edge 5: speed -1 must be a number from 0 on"),
        ([*ENDS, DocumentEdge("5", "1", "2", cost=math.nan)], "edge 5: cost nan must be a number from 0 on"),
        ([*ENDS, DocumentEdge("5", "1", "2", length=-5.0)], "edge 5: length -5 must be a number from 0 on"),
        ([vertex("1", " \t")], "vertex 1: label is blank"),
        ([vertex("1", "a\x1b[2J")], "vertex 1: control characters in label 'a␛[2J'"),
        (
            [vertex("1", "Pack  ing"), vertex("2", "pack ing")],
            "vertex 2: label 'pack ing' is taken by vertex 1",
        ),
    ],
)
def test_errors(parts: list[DocumentVertex | DocumentEdge], text: str) -> None:
    assert found(*parts) == [(text, True)]


def test_ids_at_the_limits_and_names_are_fine() -> None:
    assert found(vertex("2147483647"), vertex("-2147483648"), vertex("node-1")) == []


def test_edges_with_one_id() -> None:
    edges = [DocumentEdge(id_, "1", "2", repeats=("6",)) for id_ in ("7", "8")]
    edges += [DocumentEdge("6", "1", "2", source_id="5"), DocumentEdge("5", "1", "2")]
    assert found(vertex("1"), vertex("2"), *edges) == [("edge 6: duplicate id", True)]


def test_off_the_map() -> None:
    grid = OccupancyGrid(MapFrame(0.1, 10, 10), ())
    assert found(vertex("1", "A", x=1.5), vertex("2", x=0.5), grid=grid) == [
        ("vertex 1 (A): (1.50, 0.00) m is off the map", True),
        ("vertex 2: (0.50, 0.00) m is off the map", True),
    ]
    assert found(DocumentVertex("1", 0.5, 0.5), grid=grid) == []


def test_warnings() -> None:
    long = "名" * 17
    assert found(vertex("1", long)) == [("vertex 1: label of 34 cells, over 32", False)]
    assert found(vertex("0", "A")) == [
        ("vertex 0 (A): robots read a missing id as 0, that is as this vertex", False)
    ]
    assert found(vertex("0"), target=GraphFormat.RMF) == []
    assert found(vertex("1", type_="shelf"), vertex("2"), types={"charger"}) == [
        ("vertex 1: type 'shelf' unknown to the profile", False)
    ]
    up, down = vertex("1", "Lift A", "lift"), vertex("2", "Lift B", "elevator")
    assert found(up, down) == []
    assert found(up, down, elsewhere={"lift  a"}) == [
        ("vertex 2 (Lift B): elevator without a partner on another floor", False)
    ]


def test_vertices_that_orders_name() -> None:
    live = RouteGraph({id_: Vertex(id_, 0.0, 0.0) for id_ in ("1", "2", "3")})
    ordered = {"1": "order 7 of robot_0", "2": "order 8", "3": "order 9", "99": "order 10"}
    assert found(vertex("2", "B", x=0.6), vertex("3", x=0.5), live=live, ordered=ordered) == [
        ("vertex 1 is removed, but order 7 of robot_0 names it", True),
        ("vertex 2 (B) is moved 0.60 m, but order 8 names it", True),
    ]
