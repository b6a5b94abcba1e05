"""The simulator's own route graph: the ids are numbers, as on the wire."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from fleet_tui.model.graph import shortest_path


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

    def nearest(self, x: float, y: float) -> int:
        """Return the id of the vertex nearest to a place."""
        return min(self.vertices.values(), key=lambda one: math.dist((one.x, one.y), (x, y))).id

    def path(self, start: int, end: int) -> tuple[int, ...]:
        """Return the shortest path as vertex ids, both ends included; empty if none exists."""
        return shortest_path(self._ways, start, end)
