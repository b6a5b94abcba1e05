"""The steps of the graph editor."""

import pytest

from fleet_tui.features.graphs.rules.edits import edge_between, snapped, turned
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex

EDGE = DocumentEdge("5", "10", "9")
FLOOR = DocumentFloor(
    "f", {"9": DocumentVertex("9", 1.0, 2.03), "10": DocumentVertex("10", 4.01, 2.0)}, {"5": EDGE}
)


def test_an_edge_turns_from_low_to_high_then_back_then_both_ways() -> None:
    ways = []
    edge = EDGE
    for _ in range(3):
        ((before, after),) = turned(edge).edges
        assert before == edge and after is not None
        edge = after
        ways.append((edge.start, edge.end, edge.two_way))
    assert ways == [("9", "10", False), ("10", "9", False), ("9", "10", True)]


def test_a_place_is_in_line_with_near_vertices_else_on_the_grid() -> None:
    assert snapped(FLOOR, 3.93, 7.123, 0.1) == (4.01, 7.1)
    assert snapped(FLOOR, 2.52, 2.06, 0.3) == (2.5, 2.03)
    assert snapped(FLOOR, 2.1234, 5.0, 0.001) == (2.12, 5.0)


@pytest.mark.parametrize("ends", [("9", "10"), ("10", "9")])
def test_an_edge_is_found_from_both_ends(ends: tuple[str, str]) -> None:
    assert edge_between(FLOOR, *ends) == EDGE
    assert edge_between(FLOOR, "9", "11") is None
