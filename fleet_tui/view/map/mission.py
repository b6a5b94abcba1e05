"""The way a robot still has to drive on one floor, from its orders and its graph."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.order import Order, vertices_of
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.rules.why.traffic import stops_left
from fleet_tui.view.map.scene import Line, Mission

ORDERS_SHOWN = 8
AT_VERTEX = 0.5
"""Metres within which a robot is at a vertex: even on a one-way edge it can start from there."""

Place = tuple[str, float]
"""A vertex id, and the metres before it."""


@dataclass(frozen=True, slots=True)
class _Way:
    """A way along the graph, and its length in metres: without lines and infinite if none exists."""

    start: str | None = None
    lines: tuple[Line, ...] = ()
    length: float = math.inf


class _Routes:
    """The routes of one graph, cached: each way is searched once."""

    def __init__(self, graph: RouteGraph) -> None:
        self._graph, self._places = graph, graph.vertices
        self.elevators = tuple((v.id, 0.0) for v in graph.vertices.values() if v.role is Role.ELEVATOR)
        ends = np.array([self._line(edge.start, edge.end) for edge in graph.edges]).reshape(-1, 4)
        self._starts, self._along = ends[:, :2], ends[:, 2:] - ends[:, :2]
        self._squares = np.maximum((self._along**2).sum(axis=1), 1e-12)
        self._way = lru_cache(maxsize=512)(self._search)

    def _line(self, start: str, end: str) -> Line:
        one, other = self._places[start], self._places[end]
        return one.x, one.y, other.x, other.y

    def _search(self, start: str, goal: str) -> _Way:
        passed = self._graph.path(start, goal)
        if not passed:
            return _Way()
        lines = tuple(self._line(*pair) for pair in pairwise(passed))
        return _Way(start, lines, sum(math.dist(line[:2], line[2:]) for line in lines))

    def shortest(self, starts: tuple[Place, ...], goals: tuple[Place, ...]) -> _Way:
        """Return the shortest way from one of the starts to one of the goals."""
        ways = [(self._way(start, goal), before) for start, before in starts for goal, _ in goals]
        return min(ways, key=lambda at: at[0].length + at[1], default=(_Way(), 0.0))[0]

    def near(self, pose: Pose) -> tuple[Place, ...]:
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

    def edge(self, ends: tuple[Place, ...], ahead: str) -> Line:
        """Return the edge between two ends in the direction of one of them."""
        behind = next((id_ for id_, _ in ends if id_ != ahead), ahead)
        return self._line(behind, ahead)

    def point(self, vertex: str) -> tuple[float, float]:
        """Return the position of a vertex, in metres."""
        return self._places[vertex].x, self._places[vertex].y


@lru_cache(maxsize=2)
def _routes(chart: RobotMap) -> _Routes | None:
    return _Routes(chart.graph) if chart.graph is not None else None


def floor_of(robot: Robot, vertex: str) -> str | None:
    """Return the floor of a vertex of the robot's orders; if ids repeat, the robot's own."""
    floors = sorted(robot.charts, key=lambda name: name != robot.floor)
    graphs = ((name, robot.charts[name].graph) for name in floors)
    return next((name for name, graph in graphs if graph is not None and vertex in graph.vertices), None)


def targets(robot: Robot, floor: str) -> tuple[str, ...]:
    """Return the vertices at which the robot's current order stops on a floor."""
    current = robot.orders.current
    stops = vertices_of(current.stops) if current else ()
    return tuple(vertex for vertex in stops if floor_of(robot, vertex) == floor)


def mission(robot: Robot, floor: str) -> Mission | None:
    """Return the remaining way of the robot on a floor; a leg to or from another floor ends at an elevator.

    Cheap enough for every tick: nothing is searched again while robot and orders stay on the same edges.
    """
    orders = list(robot.orders.open[:ORDERS_SHOWN])
    routes = _routes(robot.charts[floor]) if floor in robot.charts and orders else None
    if routes is None:
        return None
    at = _whereabouts(robot, floor, routes)
    legs = list(_legs(robot, floor, routes, orders, at))
    current = tuple(line for order, way in legs if order is robot.orders.current for line in way.lines)
    following = tuple(line for order, way in legs if order is not robot.orders.current for line in way.lines)
    order, way = legs[0] if legs else (orders[0], _Way())
    if order is not robot.orders.current or robot.floor != floor or way.start is None:
        return Mission(current, following)
    return Mission(current, following, routes.edge(at, way.start))


def _legs(
    robot: Robot, floor: str, routes: _Routes, orders: list[Order], at: tuple[Place, ...]
) -> Iterator[tuple[Order, _Way]]:
    """Return the ways from the robot to one stop after the other."""
    for order in orders:
        for vertex in _stops(robot, order):
            goals = _places(robot, floor, routes, vertex)
            yield order, routes.shortest(at, goals)
            at = goals


def _stops(robot: Robot, order: Order) -> tuple[str, ...]:
    """Return the remaining vertices of an order."""
    return vertices_of(stops_left(robot, order))


def _whereabouts(robot: Robot, floor: str, routes: _Routes) -> tuple[Place, ...]:
    if robot.pose is None or robot.floor is None:
        return ()
    return routes.near(robot.pose.value) if robot.floor == floor else routes.elevators


def _places(robot: Robot, floor: str, routes: _Routes, vertex: str) -> tuple[Place, ...]:
    """Return a vertex as seen from a floor: itself, the elevators if it is on another, nothing if unknown."""
    actual = floor_of(robot, vertex)
    if actual is None:
        return ()
    return ((vertex, 0.0),) if actual == floor else routes.elevators
