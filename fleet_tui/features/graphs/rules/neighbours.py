"""Lint of vertices and edges that are too near each other: close, passing, crossing, doubled."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from fleet_tui.features.graphs.rules.finding import MOST, GraphFinding
from fleet_tui.model.graphs.document import DocumentFloor
from fleet_tui.text.language import Message

CLOSE = 0.1
"""Metres between a vertex and another one, or an edge that does not end there."""
CHUNK = 1_000_000
"""Pairs compared at once."""
MOST_PAIRS = 30_000_000
"""Maximum pairs compared; only elements in one heap have more."""

_Floats = NDArray[np.float64]
_Indices = NDArray[np.intp]


class _Shape:
    """The finite vertices and the edges between them, as arrays; edges have their ends as row numbers."""

    def __init__(self, floor: DocumentFloor) -> None:
        finite = [one for one in floor.vertices.values() if abs(one.x) <= 1e9 and abs(one.y) <= 1e9]
        self.ids = [one.id for one in finite]
        rows = {id_: n for n, id_ in enumerate(self.ids)}
        self.places = np.array([(one.x, one.y) for one in finite], np.float64).reshape(-1, 2)
        edges = [
            edge
            for edge in floor.edges.values()
            if edge.start in rows and edge.end in rows and edge.start != edge.end
        ]
        self.edges = [edge.id for edge in edges]
        ends = [(rows[edge.start], rows[edge.end]) for edge in edges]
        self.ends = np.array(ends, np.intp).reshape(-1, 2)
        self.starts = self.places[self.ends[:, 0]]
        self.stops = self.places[self.ends[:, 1]]


def neighbours(floor: DocumentFloor) -> list[list[GraphFinding]]:
    """Return the findings of each rule."""
    shape = _Shape(floor)
    return [list(_close(shape)), list(_passing(shape)), list(_crossing(shape)), list(doubled(floor))]


def _overlapping(low: _Floats, high: _Floats, of_low: _Floats) -> Iterator[tuple[_Indices, _Indices]]:
    """Yield pairs (row, other) with `of_low[other]` between `low[row]` and `high[row]`, in chunks.

    `of_low` is sorted.
    """
    first, last = np.searchsorted(of_low, low, "left"), np.searchsorted(of_low, high, "right")
    counts = np.maximum(last - first, 0)
    ends, start, done = np.cumsum(counts), 0, 0
    while start < len(counts) and done < MOST_PAIRS:
        stop = max(int(np.searchsorted(ends, done + CHUNK, "right")), start + 1)
        some = counts[start:stop]
        rows = np.repeat(np.arange(start, stop), some)
        offsets = np.arange(len(rows)) - np.repeat(np.cumsum(some) - some, some)
        yield rows, np.repeat(first[start:stop], some) + offsets
        start, done = stop, int(ends[stop - 1])


def _close(shape: _Shape) -> Iterator[GraphFinding]:
    order = np.argsort(shape.places[:, 0], kind="stable")
    places = shape.places[order]
    found = 0
    for one, other in _overlapping(places[:, 0], places[:, 0] + CLOSE, places[:, 0]):
        pairs = one < other
        one, other = one[pairs], other[pairs]
        near = np.hypot(*(places[one] - places[other]).T) < CLOSE
        for a, b in zip(order[one[near]], order[other[near]], strict=True):
            ids = shape.ids[a], shape.ids[b]
            metres = float(np.hypot(*(shape.places[a] - shape.places[b])))
            text = Message(
                "vertices {first} and {second} are {metres} m apart",
                first=ids[0],
                second=ids[1],
                metres=f"{metres:.2f}",
            )
            yield GraphFinding("close vertices", text, False, "", ids)
            found += 1
            if found > 2 * MOST:
                return


def _passing(shape: _Shape) -> Iterator[GraphFinding]:
    """Report edges that pass a vertex which is not theirs."""
    order = np.argsort(shape.places[:, 0], kind="stable")
    places = shape.places[order]
    left = np.minimum(shape.starts[:, 0], shape.stops[:, 0]) - CLOSE
    right = np.maximum(shape.starts[:, 0], shape.stops[:, 0]) + CLOSE
    low = np.minimum(shape.starts[:, 1], shape.stops[:, 1]) - CLOSE
    high = np.maximum(shape.starts[:, 1], shape.stops[:, 1]) + CLOSE
    found = 0
    for edge, at in _overlapping(left, right, places[:, 0]):
        inside = (places[at, 1] >= low[edge]) & (places[at, 1] <= high[edge])
        edge, at = edge[inside], at[inside]
        foreign = (shape.ends[edge] != order[at][:, None]).all(axis=1)
        edge, at = edge[foreign], at[foreign]
        apart = _distances(shape, edge, places[at])
        for n, vertex, metres in zip(
            *(part[apart < CLOSE] for part in (edge, order[at], apart)), strict=True
        ):
            text = Message(
                "edge {edge} passes vertex {vertex} at {metres} m",
                edge=shape.edges[n],
                vertex=shape.ids[vertex],
                metres=f"{metres:.2f}",
            )
            yield GraphFinding("passed vertex", text, False, "", (shape.ids[vertex],), (shape.edges[n],))
            found += 1
            if found > 2 * MOST:
                return


def _distances(shape: _Shape, edges: _Indices, points: _Floats) -> _Floats:
    """Return the distance of each point from the edge in its row."""
    starts, way = shape.starts[edges], shape.stops[edges] - shape.starts[edges]
    square = np.maximum((way * way).sum(axis=1), 1e-12)
    share = np.clip(((points - starts) * way).sum(axis=1) / square, 0.0, 1.0)
    found: _Floats = np.hypot(*(points - starts - way * share[:, None]).T)
    return found


def _crossing(shape: _Shape) -> Iterator[GraphFinding]:
    left = np.minimum(shape.starts[:, 0], shape.stops[:, 0])
    order = np.argsort(left, kind="stable")
    starts, stops, ends = shape.starts[order], shape.stops[order], shape.ends[order]
    low, high = np.minimum(starts, stops), np.maximum(starts, stops)
    found = 0
    for one, other in _overlapping(low[:, 0], high[:, 0], low[:, 0]):
        pairs = (one < other) & (low[one, 1] <= high[other, 1]) & (low[other, 1] <= high[one, 1])
        one, other = one[pairs], other[pairs]
        apart = (ends[one][:, :, None] != ends[other][:, None, :]).all(axis=(1, 2))
        one, other = one[apart], other[apart]
        crossed = _cross(starts[one], stops[one], starts[other], stops[other])
        for a, b in zip(order[one[crossed]], order[other[crossed]], strict=True):
            ids = shape.edges[a], shape.edges[b]
            text = Message("edges {first} and {second} cross without a vertex", first=ids[0], second=ids[1])
            yield GraphFinding("crossing", text, False, "", (), ids)
            found += 1
            if found > 2 * MOST:
                return


def _cross(a: _Floats, b: _Floats, c: _Floats, d: _Floats) -> NDArray[np.bool_]:
    """Tell for each row whether the lines a-b and c-d cross within both."""

    def side(start: _Floats, end: _Floats, point: _Floats) -> _Floats:
        way, off = end - start, point - start
        found: _Floats = way[:, 0] * off[:, 1] - way[:, 1] * off[:, 0]
        return found

    over = side(a, b, c) * side(a, b, d) < 0
    found: NDArray[np.bool_] = over & (side(c, d, a) * side(c, d, b) < 0)
    return found


def doubled(floor: DocumentFloor) -> Iterator[GraphFinding]:
    """Report edges that lead the same way as another."""
    ways = dict[tuple[str, str], str]()
    for id_, edge in floor.edges.items():
        both = [(edge.start, edge.end), (edge.end, edge.start)][: 1 + edge.two_way]
        other = next((ways[way] for way in both if way in ways), None)
        if other is not None:
            text = Message(
                "edge {id} duplicates edge {other} from {start} to {end}",
                id=id_,
                other=other,
                start=edge.start,
                end=edge.end,
            )
            yield GraphFinding("doubled edge", text, False, "", (), (id_, other))
        ways.update(dict.fromkeys(both, id_))
