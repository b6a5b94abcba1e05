"""Reach and detours."""

import math

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.graphs.rules.reach import longest_detour, reach
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex


def graph(ways: str, directed: bool = True, roles: str = "") -> RouteGraph:
    """Vertices a, b, ... in a row, and edges such as `ab bc`."""
    names = "abcdefgh"
    vertices = {
        name: Vertex(name, float(n), 0.0, Role.ELEVATOR if name in roles else Role.PLAIN)
        for n, name in enumerate(names)
    }
    edges = tuple(Edge(str(n), way[0], way[1]) for n, way in enumerate(ways.split()))
    return RouteGraph(vertices, edges, directed)


LABELS = {name: name.upper() for name in "abcdef"}


def test_traps_and_places_that_cannot_be_reached() -> None:
    found = reach(graph("ab bc ca cd ea"), LABELS)
    assert (found.largest, found.lost, found.traps) == (frozenset("abc"), ("d", "e", "f"), ("d",))


def test_elevators_connect_over_other_floors() -> None:
    ways = graph("ab bc ca de ed", roles="ad")
    assert reach(ways, LABELS).lost == ("d", "e", "f")
    assert reach(ways, LABELS, with_lifts=True).lost == ("f",)


def test_no_graph() -> None:
    assert reach(RouteGraph(), {"x": "X"}).lost == () and longest_detour(RouteGraph(), {"x": "X"}) is None


@given(st.lists(st.tuples(st.sampled_from("abcdef"), st.sampled_from("abcdef")), max_size=14))
def test_the_largest_part_is_that_of_ways_both_ways(pairs: list[tuple[str, str]]) -> None:
    ways = graph(" ".join("".join(pair) for pair in pairs))
    part = reach(ways, LABELS).largest

    def together(start: str) -> set[str]:
        return {end for end in ways.vertices if ways.path(start, end) and ways.path(end, start)}

    assert len(part) == max(len(together(start)) for start in ways.vertices)
    assert all(together(start) == part for start in part)


def test_the_longest_detour() -> None:
    detour = longest_detour(graph("ab bc cd da"), {name: name for name in "ab"})
    assert detour is not None and (detour.start, detour.end) == ("b", "a")
    assert math.isclose(detour.factor, 5.0) and detour.straight == 1.0
