"""Lint by format."""

from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.features.graphs.rules.targets import of_target
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    of_floor,
)
from tests.support.graph_files import again, sample


def texts(document: GraphDocument, target: GraphFormat | None, vehicle: str = "") -> list[str]:
    found = list(of_target(document, LintInputs(target=target, vehicle_type=vehicle)))
    assert all(one.is_error for one in found)
    return [one.text for one in found]


def floor(name: str, *vertices: DocumentVertex) -> DocumentFloor:
    return DocumentFloor(name, {one.id: one for one in vertices})


def test_rmf() -> None:
    floors = {
        "a": floor("a", DocumentVertex("1", 0.0, 0.0, "Base"), DocumentVertex("2", 1.0, 0.0)),
        "b": floor("b", DocumentVertex("1", 0.2, 0.0, "Base"), DocumentVertex("2", 0.0, 0.0)),
    }
    document = GraphDocument("s", floors, (Lift("A", (("a", "1"), ("b", "1"), ("b", "2"))),))
    assert texts(document, GraphFormat.RMF) == [
        "vertex 1: label 'Base' is taken on a; RMF allows one per site",
        "lift A: its stops on a and b are 0.20 m apart",
        "lift A: its stops on b and b are 0.20 m apart",
        "lift A: two stops on b",
    ]
    assert texts(document, None) == []


def test_nav2() -> None:
    assert texts(of_floor(DocumentFloor("f")), GraphFormat.GEOJSON) == [
        "no vertex: nothing to drive on was read"
    ]
    one = floor("f", DocumentVertex("65536", 0.0, 0.0))
    assert texts(of_floor(one), GraphFormat.GEOJSON) == [
        "no edge: Nav2 does not load such a graph",
        "vertex 65536: id over 65535, too large for Nav2's messages",
    ]
    two = DocumentFloor("f", one.vertices, {"9" * 30: DocumentEdge("9" * 30, "65536", "65536")})
    assert len(texts(of_floor(two), GraphFormat.GEOJSON)) == 2


def test_lif() -> None:
    assert texts(sample(), GraphFormat.LIF) == [
        "no vehicle type at 4 vertices and 4 edges: no vehicle may use them"
    ]
    assert texts(sample(), GraphFormat.LIF, "agv") == []
    assert texts(again(sample(), GraphFormat.LIF), GraphFormat.LIF) == []
