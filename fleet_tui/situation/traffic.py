"""The next way of a robot, and the robots on it."""

import math
from functools import lru_cache
from itertools import pairwise

from msgspec import Struct

from fleet_tui.model.by_identity import Same
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.order import Order, Stop
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.situation.pose_checks.off_route import graph_here

AT_VERTEX = 0.5
"""Metres within which a robot is at a vertex."""

ROBOT_WIDTH = 0.8
"""Metres beside the line of a way within which a robot is on it."""

VERTICES_AHEAD = 2
"""Number of vertices of its way that are checked."""

NEAR = 4.0
"""Metres within which a robot keeps its distance; at a vertex it also waits for the whole next edge."""

Point = tuple[float, float]


class InTheWay(Struct, frozen=True, eq=False):
    """A robot on another one's way, `ahead` metres before it, near `vertex` of that way."""

    robot: Robot
    ahead: float
    vertex: str


def stops_left(robot: Robot, order: Order) -> tuple[Stop, ...]:
    """Return the remaining stops of an order, as far as known: of the current one the last with the cargo on
    board, else those from its progress on."""
    if not robot.orders.is_current(order):
        return order.stops
    if robot.has_cargo:
        return order.stops[-1:]
    return order.stops[_stop_driven_to(robot, order) or 0 :]


def _stop_driven_to(robot: Robot, order: Order) -> int | None:
    """Return the current stop of an order, by its progress."""
    progress = robot.progress.value if robot.progress else None
    if progress is None or progress.goal != order.id or progress.stop is None:
        return None
    return min(progress.stop, len(order.stops) - 1)


def next_stop(robot: Robot) -> str | None:
    """Return the vertex that its current order leads to now, None also if it leads to a pose, and if neither
    cargo nor progress shows which of several stops it is."""
    order = robot.orders.current
    stops = stops_left(robot, order) if order is not None else ()
    if order is None or not stops:
        return None
    is_known = robot.kind.brings_cargo or _stop_driven_to(robot, order) is not None
    if len(stops) > 1 and not is_known:
        return None
    return stops[0].vertex if stops[0].pose is None else None


def vertex_here(robot: Robot) -> str | None:
    """Return the vertex that it is at, None between two vertices."""
    graph = graph_here(robot)
    if graph is None or robot.pose is None:
        return None
    nearest = _nearest(graph, robot.pose.value)
    if nearest is None or _distance(graph, nearest, robot.pose.value) > AT_VERTEX:
        return None
    return nearest


def way_ahead(robot: Robot) -> tuple[str, ...]:
    """Return the vertices before it on the way to its next stop; to an elevator if that is on another
    floor."""
    graph, stop = graph_here(robot), next_stop(robot)
    start = _nearest(graph, robot.pose.value) if graph is not None and robot.pose is not None else None
    if graph is None or robot.pose is None or stop is None or start is None:
        return ()
    lifts = [vertex.id for vertex in graph.vertices.values() if vertex.role is Role.ELEVATOR]
    ways = [_path(Same(graph), start, goal) for goal in ([stop] if stop in graph.vertices else lifts)]
    way = min(filter(None, ways), key=len, default=())
    if len(way) > 1 and _distance(graph, way[1], robot.pose.value) <= _length(graph, *way[:2]):
        return way[1:]
    return way


def points_ahead(robot: Robot) -> list[Point]:
    """Return where a robot is, and the next vertices of its way; empty without a way."""
    graph, pose = graph_here(robot), robot.pose
    way = way_ahead(robot)[:VERTICES_AHEAD]
    if graph is None or pose is None or not way:
        return []
    return [(pose.value.x, pose.value.y), *((graph.vertices[id_].x, graph.vertices[id_].y) for id_ in way)]


def in_the_way(state: FleetState, robot: Robot) -> InTheWay | None:
    """Return the nearest robot on the next vertices and edges of its way, in the same frame."""
    way, points = way_ahead(robot)[:VERTICES_AHEAD], points_ahead(robot)
    if not points:
        return None
    # Who plans its own way waits for no edge, and who is parked drives on none.
    waits_for_edge = not robot.kind.keeps_goals and vertex_here(robot) is not None
    found = list[InTheWay]()
    for other in state.robots.values():
        if other is not robot and same_frame(state, robot, other) and other.pose is not None:
            at = _along(points, (other.pose.value.x, other.pose.value.y))
            if at is not None and (at[0] < NEAR or (waits_for_edge and at[1] == 0 and other.orders.current)):
                found.append(InTheWay(other, at[0], way[at[1]]))
    return min(found, key=lambda one: one.ahead, default=None)


def same_frame(state: FleetState, one: Robot, other: Robot) -> bool:
    """Tell whether positions can be compared: both are on one floor and their maps have the same place in the
    world."""
    if other.floor is None or other.floor != one.floor or not state.is_fresh(other, "pose"):
        return False
    frames = [robot.maps.get(one.floor, RobotMap()).frame for robot in (one, other)]
    return None in frames or frames[0] == frames[1]


def _along(points: list[Point], at: Point) -> tuple[float, int] | None:
    """Return the distance of a point along a line, and its part of the line; None beside or behind it."""
    before = 0.0
    for part, ((x, y), (to_x, to_y)) in enumerate(pairwise(points)):
        length = math.dist((x, y), (to_x, to_y))
        if length**2 > 0.0:
            share = ((at[0] - x) * (to_x - x) + (at[1] - y) * (to_y - y)) / length**2
            reached = min(max(share, 0.0), 1.0)
            beside = math.dist(at, (x + reached * (to_x - x), y + reached * (to_y - y)))
            if (share > 0.0 or part > 0) and beside < ROBOT_WIDTH:
                return before + reached * length, part
        before += length
    return None


@lru_cache(maxsize=512)
def _path(graph: Same[RouteGraph], start: str, goal: str) -> tuple[str, ...]:
    """Search a path once: robots that stand ask for theirs each second."""
    return graph.value.path(start, goal)


def _nearest(graph: RouteGraph, pose: Pose) -> str | None:
    return min(graph.vertices, key=lambda id_: _distance(graph, id_, pose), default=None)


def _distance(graph: RouteGraph, vertex: str, pose: Pose) -> float:
    place = graph.vertices[vertex]
    return math.dist((place.x, place.y), (pose.x, pose.y))


def _length(graph: RouteGraph, start: str, end: str) -> float:
    one, other = graph.vertices[start], graph.vertices[end]
    return math.dist((one.x, one.y), (other.x, other.y))
