"""Shortest ways, held against trying every way there is."""

import gc
import math
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.graph import Edge, RouteGraph, Vertex

IDS = st.text(max_size=3)
COORDINATES = st.floats(-100, 100)


@st.composite
def graphs(draw: st.DrawFn) -> RouteGraph:
    ids = draw(st.lists(IDS, min_size=1, max_size=6, unique=True))
    vertices = {id_: Vertex(id_, draw(COORDINATES), draw(COORDINATES)) for id_ in ids}
    ends = draw(st.lists(st.tuples(*[st.sampled_from([*ids, "nowhere"])] * 2), max_size=12))
    edges = tuple(Edge(str(n), start, end) for n, (start, end) in enumerate(ends))
    return RouteGraph(vertices, edges, draw(st.booleans()))


def steps(graph: RouteGraph) -> set[tuple[str, str]]:
    there = {(edge.start, edge.end) for edge in graph.edges}
    both = there if graph.directed else there | {(end, start) for start, end in there}
    return {step for step in both if step[0] in graph.vertices and step[1] in graph.vertices}


def length(graph: RouteGraph, way: tuple[str, ...]) -> float:
    at = [(graph.vertices[id_].x, graph.vertices[id_].y) for id_ in way]
    return sum(math.dist(one, other) for one, other in pairwise(at))


def every_way(graph: RouteGraph, start: str, end: str, before: tuple[str, ...] = ()) -> list[tuple[str, ...]]:
    if start == end:
        return [(*before, end)]
    onward = [after for here, after in steps(graph) if here == start and after not in before]
    return [way for after in onward for way in every_way(graph, after, end, (*before, start))]


@given(graphs(), st.integers(0, 6), st.integers(0, 6))
def test_no_way_is_shorter(graph: RouteGraph, first: int, last: int) -> None:
    names = [*graph.vertices, *["nowhere"] * 7]
    start, end = names[first], names[last]
    way = graph.path(start, end)
    if start not in graph.vertices or end not in graph.vertices:
        assert way == ()
        return
    ways = every_way(graph, start, end)
    if not ways:
        assert way == ()
        return
    assert way[0] == start and way[-1] == end
    assert set(pairwise(way)) <= steps(graph)
    best = min(length(graph, other) for other in ways)
    assert math.isclose(length(graph, way), best, rel_tol=1e-9, abs_tol=1e-9)


def test_directed_edges_go_one_way() -> None:
    vertices = {id_: Vertex(id_, float(id_), 0.0) for id_ in ("1", "2")}
    edges = (Edge("7", "1", "2"),)
    one_way, both = RouteGraph(vertices, edges, directed=True), RouteGraph(vertices, edges)
    assert (one_way.path("1", "2"), one_way.path("2", "1")) == (("1", "2"), ())
    assert both.path("2", "1") == ("2", "1")


def test_unknown_vertices_have_no_way() -> None:
    graph = RouteGraph({"1": Vertex("1", 0.0, 0.0)}, (Edge("0", "1", "9"), Edge("1", "9", "1")))
    assert graph.path("1", "9") == graph.path("9", "1") == graph.path("8", "8") == ()
    assert graph.path("1", "1") == ("1",)
    assert graph.neighbours == {"1": ()}


def test_a_large_graph_makes_no_search_for_garbage_longer() -> None:
    """Each robot may have 20,000 vertices, and the network loop looks for garbage every minute."""
    assert not any(map(gc.is_tracked, (Vertex("1", 0.0, 0.0), Edge("1", "2", "3"))))


def test_metres_to_places_are_those_of_the_shortest_path_to_the_nearest() -> None:
    vertices = {id_: Vertex(id_, x, 0.0) for id_, x in (("a", 0.0), ("b", 1.0), ("c", 3.0), ("d", 9.0))}
    edges = (Edge("0", "a", "b"), Edge("1", "b", "c"), Edge("2", "c", "d"))
    assert RouteGraph(vertices, edges).metres_to(["a", "d"]) == {"a": 0.0, "b": 1.0, "c": 3.0, "d": 0.0}
    assert RouteGraph(vertices, edges, directed=True).metres_to(["b", "gone"]) == {"b": 0.0, "a": 1.0}
