"""Vertices and edges too near each other."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.graphs.rules import neighbours as module
from fleet_tui.features.graphs.rules.neighbours import neighbours
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex


def floor(*places: tuple[float, float], edges: tuple[tuple[int, int], ...] = ()) -> DocumentFloor:
    return DocumentFloor(
        "f",
        {str(n): DocumentVertex(str(n), x, y) for n, (x, y) in enumerate(places)},
        {f"e{n}": DocumentEdge(f"e{n}", str(a), str(b)) for n, (a, b) in enumerate(edges)},
    )


def texts(found: DocumentFloor) -> list[str]:
    return [one.text for group in neighbours(found) for one in group]


def test_close_vertices_and_passed_ones() -> None:
    assert texts(floor((0, 0), (0.05, 0.05), (3, 3))) == ["vertices 0 and 1 are 0.07 m apart"]
    assert texts(floor((0, 0), (2, 0), (1, 0.09), (1, 0.11), edges=((0, 1),)))[1:] == [
        "edge e0 passes vertex 2 at 0.09 m"
    ]


def test_crossings_but_not_at_a_common_vertex() -> None:
    places = ((0.0, 0.0), (2.0, 2.0), (0.0, 2.0), (2.0, 0.0))
    assert texts(floor(*places, edges=((0, 1), (2, 3), (0, 2), (1, 2)))) == [
        "edges e0 and e1 cross without a vertex"
    ]


def test_doubled_edges() -> None:
    base = floor((0, 0), (1, 0), edges=((0, 1), (1, 0)))
    assert texts(base) == ["edge e1 duplicates edge e0 from 1 to 0"]
    one_way = {id_: DocumentEdge(id_, a, b, False) for id_, a, b in (("1", "0", "1"), ("2", "1", "0"))}
    assert texts(DocumentFloor("f", base.vertices, one_way)) == []


def test_places_that_are_none_are_left_out() -> None:
    assert texts(floor((math.nan, 0), (math.inf, 0), (1e300, 0), edges=((0, 1), (1, 2)))) == []
    assert texts(floor()) == []


POINTS = st.lists(st.tuples(st.integers(0, 12), st.integers(0, 12)), min_size=2, max_size=9, unique=True)


@given(POINTS, st.data())
def test_the_same_as_one_by_one(points: list[tuple[int, int]], data: st.DataObject) -> None:
    places = [(x / 16, y / 16) for x, y in points]
    ends = st.tuples(st.integers(0, len(places) - 1), st.integers(0, len(places) - 1))
    pairs = data.draw(st.lists(ends.filter(lambda pair: pair[0] != pair[1]), max_size=6))
    found = floor(*places, edges=tuple(pairs))
    close = {
        frozenset((str(a), str(b)))
        for a in range(len(places))
        for b in range(a)
        if math.dist(places[a], places[b]) < 0.1
    }
    groups = neighbours(found)
    assert {frozenset(one.vertices) for one in groups[0]} == close
    passed = {
        (f"e{n}", str(at))
        for n, pair in enumerate(pairs)
        for at in range(len(places))
        if at not in pair and _distance(places[at], places[pair[0]], places[pair[1]]) < 0.1
    }
    assert {(one.edges[0], one.vertices[0]) for one in groups[1]} == passed


def _distance(at: tuple[float, float], start: tuple[float, float], end: tuple[float, float]) -> float:
    """To the nearest of many points of the line, and as near as they are."""
    way = end[0] - start[0], end[1] - start[1]
    share = ((at[0] - start[0]) * way[0] + (at[1] - start[1]) * way[1]) / (way[0] ** 2 + way[1] ** 2)
    share = min(max(share, 0.0), 1.0)
    return math.dist(at, (start[0] + share * way[0], start[1] + share * way[1]))


def test_a_heap_takes_no_longer_than_its_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "CHUNK", 50)
    monkeypatch.setattr(module, "MOST_PAIRS", 1000)
    heap = floor(*((0.0, n / 1000) for n in range(200)), edges=tuple((n, n + 1) for n in range(199)))
    assert 0 < len(texts(heap)) < 2000
