"""The route graph that robots drive on: vertices, edges, labels, shortest paths."""

import heapq
import math
from collections.abc import Iterable, Mapping
from enum import Enum
from functools import cached_property
from typing import TypeVar

from msgspec import Struct, field

from fleet_tui.model.geometry import Line

Id = TypeVar("Id", str, int)


class Role(Enum):
    """The role of a vertex, whatever the robot stack calls it."""

    PLAIN = "plain"
    ELEVATOR = "elevator"
    DOCKING = "docking"


class Vertex(Struct, frozen=True, gc=False):
    """A place on the graph: x, y in metres in the map's world frame. `type` is the robot stack's own word."""

    id: str
    x: float
    y: float
    role: Role = Role.PLAIN
    type: str = ""


class Edge(Struct, frozen=True, gc=False):
    """A drivable connection between two vertex ids. reverse_id: the id of the way back, where it has one."""

    id: str
    start: str
    end: str
    reverse_id: str = ""


class RouteGraph(Struct, frozen=True, dict=True):
    """Vertices by id and the edges between them; edges go both ways unless `directed`."""

    vertices: Mapping[str, Vertex] = field(default_factory=dict)
    edges: tuple[Edge, ...] = ()
    directed: bool = False

    @cached_property
    def neighbours(self) -> Mapping[str, tuple[tuple[str, float], ...]]:
        """Return, for each vertex id, the reachable ids with their distance in metres."""
        found: dict[str, list[tuple[str, float]]] = {id_: [] for id_ in self.vertices}
        for edge in self.edges:
            start, end = self.vertices.get(edge.start), self.vertices.get(edge.end)
            if start is None or end is None:
                continue
            length = math.dist((start.x, start.y), (end.x, end.y))
            found[edge.start].append((edge.end, length))
            if not self.directed:
                found[edge.end].append((edge.start, length))
        return {id_: tuple(ways) for id_, ways in found.items()}

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """Return the edges between known vertices, in metres."""
        places = self.vertices
        ends = ((places.get(edge.start), places.get(edge.end)) for edge in self.edges)
        return tuple((one.x, one.y, other.x, other.y) for one, other in ends if one and other)

    @cached_property
    def chargers(self) -> tuple[Vertex, ...]:
        """Return the vertices at which robots charge."""
        return tuple(vertex for vertex in self.vertices.values() if vertex.role is Role.DOCKING)

    def path(self, start: str, end: str) -> tuple[str, ...]:
        """The shortest path as vertex ids, both ends included; empty if none exists."""
        if start not in self.vertices or end not in self.vertices:
            return ()
        return shortest_path(self.neighbours, start, end)

    def metres_to(self, ends: Iterable[str]) -> Mapping[str, float]:
        """Return, for each vertex id from which a path leads to one of these, the metres to the nearest."""
        back: dict[str, list[tuple[str, float]]] = {id_: [] for id_ in self.vertices}
        for vertex, ways in self.neighbours.items():
            for neighbour, length in ways:
                back[neighbour].append((vertex, length))
        metres = {end: 0.0 for end in ends if end in self.vertices}
        queue = [(0.0, end) for end in metres]
        while queue:
            so_far, vertex = heapq.heappop(queue)
            for neighbour, length in back[vertex]:
                if so_far + length < metres.get(neighbour, math.inf):
                    metres[neighbour] = so_far + length
                    heapq.heappush(queue, (so_far + length, neighbour))
        return metres


def shortest_path(neighbours: Mapping[Id, Iterable[tuple[Id, float]]], start: Id, end: Id) -> tuple[Id, ...]:
    """Return the shortest path over `neighbours` (each with the metres to it), both ends included; empty if
    none exists."""
    reached: dict[Id, tuple[float, Id]] = {start: (0.0, start)}
    queue = [(0.0, start)]
    while queue:
        metres, vertex = heapq.heappop(queue)
        if vertex == end:
            break
        for neighbour, length in neighbours[vertex]:
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
