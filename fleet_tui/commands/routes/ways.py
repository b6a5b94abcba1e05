"""Ways along a route graph: searched once, then cached."""

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from fleet_tui.model.by_identity import Same
from fleet_tui.model.geometry import Line, Pose
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.robot import RobotMap

AT_VERTEX = 0.5
"""Metres within which a robot is at a vertex: even on a one-way edge it can start from there."""

Spot = tuple[str, float]
"""A vertex id, and the metres before it."""


@dataclass(frozen=True, slots=True)
class Way:
    """A way along the graph, and its length in metres: without lines and infinite if none exists."""

    start: str | None = None
    lines: tuple[Line, ...] = ()
    length: float = math.inf


class Routes:
    """The routes of one graph, cached: each way is searched once."""

    def __init__(self, graph: RouteGraph) -> None:
        self._graph = graph
        self._places = graph.vertices
        self.elevators = tuple((v.id, 0.0) for v in graph.vertices.values() if v.role is Role.ELEVATOR)
        ends = np.array([self._line(edge.start, edge.end) for edge in graph.edges]).reshape(-1, 4)
        self._starts = ends[:, :2]
        self._along = ends[:, 2:] - ends[:, :2]
        self._squares = np.maximum((self._along**2).sum(axis=1), 1e-12)
        self._way = lru_cache(maxsize=512)(self._search)

    def _line(self, start: str, end: str) -> Line:
        one, other = self._places[start], self._places[end]
        return one.x, one.y, other.x, other.y

    def _search(self, start: str, goal: str) -> Way:
        passed = self._graph.path(start, goal)
        if not passed:
            return Way()
        lines = tuple(self._line(*pair) for pair in pairwise(passed))
        return Way(start, lines, sum(math.dist(line[:2], line[2:]) for line in lines))

    def shortest(self, starts: tuple[Spot, ...], goals: tuple[Spot, ...]) -> Way:
        """Return the shortest way from one of the starts to one of the goals."""
        ways = [(self._way(start, goal), before) for start, before in starts for goal, _ in goals]
        return min(ways, key=lambda at: at[0].length + at[1], default=(Way(), 0.0))[0]

    def near(self, pose: Pose) -> tuple[Spot, ...]:
        """Return the two ends of the edge that the robot is on; infinitely far is one that it may not drive
        to."""
        at = (pose.x, pose.y)
        if not self._graph.edges or not all(map(math.isfinite, at)):
            return ()
        offset = np.array(at) - self._starts
        share = np.clip((offset * self._along).sum(axis=1) / self._squares, 0.0, 1.0)
        off = ((offset - share[:, None] * self._along) ** 2).sum(axis=1)
        edge = self._graph.edges[int(off.argmin())]
        start, end = ((v, math.dist(at, self.point(v))) for v in (edge.start, edge.end))
        back = any(id_ == edge.start for id_, _ in self._graph.neighbours[edge.end])
        return (end, start if back or start[1] < AT_VERTEX else (edge.start, math.inf))

    def edge(self, ends: tuple[Spot, ...], ahead: str) -> Line:
        """Return the edge between two ends in the direction of one of them."""
        behind = next((id_ for id_, _ in ends if id_ != ahead), ahead)
        return self._line(behind, ahead)

    def point(self, vertex: str) -> tuple[float, float]:
        """Return the position of a vertex, in metres."""
        return self._places[vertex].x, self._places[vertex].y


def routes_of(robot_map: RobotMap) -> Routes | None:
    """Return the routes of a map, None without a graph."""
    return _routes_of(Same(robot_map.graph)) if robot_map.graph is not None else None


@lru_cache(maxsize=8)  # two floors, each with and without a closed edge
def _routes_of(graph: Same[RouteGraph]) -> Routes:
    return Routes(graph.value)
