"""The difference of two graphs."""

import math

from fleet_tui.features.graphs.rules.difference import difference
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex


def floor(vertices: list[DocumentVertex], edges: list[DocumentEdge]) -> DocumentFloor:
    return DocumentFloor("f", {one.id: one for one in vertices}, {one.id: one for one in edges})


def test_every_kind_of_change() -> None:
    before = floor(
        [DocumentVertex(str(n), float(n), 0.0, f"V{n}") for n in range(5)],
        [DocumentEdge("1", "0", "1"), DocumentEdge("2", "1", "2"), DocumentEdge("3", "2", "3", False)],
    )
    after = floor(
        [
            DocumentVertex("0", 0.009, 0.0, "V0"),
            DocumentVertex("1", 1.5, 0.0, "V1", "dock"),
            DocumentVertex("2", 2.0, 0.0, "New\x1b"),
            DocumentVertex("3", 3.0, 0.0),
            DocumentVertex("10", 3.0, 0.0),
        ],
        [DocumentEdge("1", "1", "0"), DocumentEdge("3", "3", "2", False), DocumentEdge("4", "0", "3")],
    )
    assert [(one.kind, one.text) for one in difference(before, after)] == [
        ("moved", "vertex 1 (V1): 0.50 m"),
        ("retyped", "vertex 1 (V1): plain -> dock"),
        ("relabelled", 'vertex 2: "V2" -> "New␛"'),
        ("relabelled", 'vertex 3: "V3" -> no label'),
        ("removed", "vertex 4 (V4)"),
        ("added", "vertex 10"),
        ("removed", "edge 2 1 <> 2"),
        ("rewired", "edge 3: 2 > 3 -> 3 > 2"),
        ("added", "edge 4 0 <> 3"),
    ]
    assert difference(before, before) == ()


def test_nowhere_is_the_same_as_nowhere() -> None:
    lost, found = (floor([DocumentVertex("0", x, 0.0)], []) for x in (math.nan, 0.0))
    assert difference(lost, lost) == ()
    assert [one.kind for one in difference(lost, found)] == ["moved"]
