"""The simulator's own route graph: the ids are numbers, as on the wire."""

import heapq
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True)
class SimVertex:
    """A place: x, y in metres."""

    id: int
    x: float
    y: float


@dataclass(frozen=True)
class SimEdge:
    """A connection between two vertices, both ways."""

    id: int
    start: int
    end: int


@dataclass(frozen=True)
class SimGraph:
    """Vertices by id and the edges between them."""

    vertices: Mapping[int, SimVertex]
    edges: tuple[SimEdge, ...]

    @cached_property
    def _ways(self) -> Mapping[int, list[tuple[int, float]]]:
        found: dict[int, list[tuple[int, float]]] = {id_: [] for id_ in self.vertices}
        for edge in self.edges:
            start, end = self.vertices[edge.start], self.vertices[edge.end]
            length = math.dist((start.x, start.y), (end.x, end.y))
            found[edge.start].append((edge.end, length))
            found[edge.end].append((edge.start, length))
        return found

    def path(self, start: int, end: int) -> tuple[int, ...]:
        """The shortest way as vertex ids, both ends included; empty if there is none."""
        reached: dict[int, tuple[float, int]] = {start: (0.0, start)}
        queue = [(0.0, start)]
        while queue:
            metres, vertex = heapq.heappop(queue)
            for neighbour, length in self._ways[vertex]:
                further = metres + length
                if neighbour not in reached or further < reached[neighbour][0]:
                    reached[neighbour] = (further, vertex)
                    heapq.heappush(queue, (further, neighbour))
        if end not in reached:
            return ()
        way = [end]
        while way[-1] != start:
            way.append(reached[way[-1]][1])
        return tuple(reversed(way))
