"""Reach: the vertices from which robots get to all others, and the way that is longest for its distance."""

import heapq
import math
from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.order import natural

MOST_STARTS = 150
"""Maximum labelled vertices from which ways are measured: each takes some milliseconds on a large floor."""

Ways = Mapping[str, tuple[tuple[str, float], ...]]


class Detour(Struct, frozen=True):
    """The way between two labelled vertices that is longest for their distance, in metres."""

    start: str
    end: str
    metres: float
    straight: float

    @property
    def factor(self) -> float:
        """Return how many times longer the way is."""
        return self.metres / self.straight


class Reach(Struct, frozen=True):
    """largest: the vertices that can all be reached from each other; lost: the labelled ones outside;
    traps: those of `lost` that can be reached, but not left."""

    largest: frozenset[str]
    lost: tuple[str, ...]
    traps: tuple[str, ...] = ()


def reach(graph: RouteGraph, labels: Mapping[str, str], with_lifts: bool = False) -> Reach:
    """Return the largest strongly connected part of a graph and the labelled vertices outside it.

    with_lifts: elevators are connected over other floors.
    """
    ways: dict[str, tuple[tuple[str, float], ...]] = dict(graph.neighbours)
    shafts = [id_ for id_, one in graph.vertices.items() if one.role is Role.ELEVATOR] if with_lifts else []
    for one, other in zip(shafts, shafts[1:] + shafts[:1], strict=True):
        ways[one] = (*ways[one], (other, 0.0))
    parts = sorted(_parts(ways), key=len)
    largest = frozenset(parts[-1] if parts else ())
    lost = sorted((id_ for id_ in labels if id_ in graph.vertices and id_ not in largest), key=natural)
    reachable = _reachable(ways, largest) if lost else set()
    return Reach(largest, tuple(lost), tuple(id_ for id_ in lost if id_ in reachable))


def _reachable(ways: Ways, starts: frozenset[str]) -> set[str]:
    seen, todo = set(starts), list(starts)
    while todo:
        for neighbour, _ in ways[todo.pop()]:
            if neighbour not in seen:
                seen.add(neighbour)
                todo.append(neighbour)
    return seen


def _parts(ways: Ways) -> list[list[str]]:
    """Return the strongly connected parts, by Kosaraju's method: by ends forwards, then backwards."""
    back: dict[str, list[str]] = {id_: [] for id_ in ways}
    for id_, those in ways.items():
        for neighbour, _ in those:
            back[neighbour].append(id_)
    found, seen = list[list[str]](), set[str]()
    for start in reversed(_by_end(ways)):
        if start in seen:
            continue
        seen.add(start)
        part, todo = [start], [start]
        while todo:
            new = [one for one in back[todo.pop()] if one not in seen]
            seen.update(new)
            fresh = list(dict.fromkeys(new))
            part += fresh
            todo += fresh
        found.append(part)
    return found


def _by_end(ways: Ways) -> list[str]:
    """Return the vertices in the order in which a search in depth leaves them."""
    order, seen = list[str](), set[str]()
    for root in ways:
        if root in seen:
            continue
        seen.add(root)
        stack = [(root, iter(ways[root]))]
        while stack:
            id_, rest = stack[-1]
            following = next((one for one, _ in rest if one not in seen), None)
            if following is None:
                order.append(id_)
                stack.pop()
            else:
                seen.add(following)
                stack.append((following, iter(ways[following])))
    return order


def longest_detour(graph: RouteGraph, labels: Mapping[str, str]) -> Detour | None:
    """Return the longest detour between labelled vertices, None if no two of them are connected and apart.

    Of many labelled vertices only the first are starts.
    """
    ends = sorted((id_ for id_ in labels if id_ in graph.vertices), key=natural)
    best: Detour | None = None
    for start in ends[:MOST_STARTS]:
        metres, at = _distances(graph, start), graph.vertices[start]
        for end in ends:
            straight = math.dist((at.x, at.y), (graph.vertices[end].x, graph.vertices[end].y))
            if end not in metres or not straight > 0.0:
                continue
            if best is None or metres[end] / straight > best.factor:
                best = Detour(start, end, metres[end], straight)
    return best


def _distances(graph: RouteGraph, start: str) -> dict[str, float]:
    """Return the length of the shortest way to each vertex that can be reached."""
    found, queue = dict[str, float](), [(0.0, start)]
    while queue:
        metres, id_ = heapq.heappop(queue)
        if id_ in found:
            continue
        found[id_] = metres
        for neighbour, length in graph.neighbours[id_]:
            if neighbour not in found and length < math.inf:
                heapq.heappush(queue, (metres + length, neighbour))
    return found
