"""The edges on which robots are held up by something in front of them, until another robot drives over."""

import math
from collections.abc import Mapping, Sequence

from msgspec.structs import replace

from fleet_tui.model.desk.desk import Ends, ends_of
from fleet_tui.model.fleet import BlockedEdge, FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.robots import is_blocked_for_long
from fleet_tui.situation.traffic import AT_VERTEX, ROBOT_WIDTH, same_frame

SUSPECT_FOR = 30.0
"""Seconds after a jump of its pose for which a robot may be elsewhere."""
FACING = math.pi / 4
"""Radians from a robot's heading within which it faces an edge."""
MOST_WATCHED = 20
"""Edges that are watched; in a flood of alarms those of the first robots."""
AT_END = 1.5
"""Metres from the end of an edge within which a robot on it has driven all of it: less than to a robot that
waits before one there."""


def edge_under(robot: Robot) -> Ends | None:
    """Return the edge that a robot is on, at a vertex the one that it faces; None if that is unknown."""
    from fleet_tui.commands.routes.order_draft import place_of  # numpy: not before a robot is held up

    for floor, spots in place_of(robot):
        at = [vertex for vertex, metres in spots if metres <= AT_VERTEX]
        if at:
            return _edge_ahead(robot, floor, at[0])
        if len(spots) == 2:
            return ends_of(floor, spots[0][0], spots[1][0])
    return None


def _edge_ahead(robot: Robot, floor: str, vertex: str) -> Ends | None:
    graph = robot.maps[floor].graph
    if graph is None or robot.pose is None:
        return None
    here, yaw = graph.vertices[vertex], robot.pose.value.yaw
    turns = {}
    for edge in graph.edges:
        if vertex in (edge.start, edge.end):
            other = edge.end if edge.start == vertex else edge.start
            there = graph.vertices[other]
            towards = math.atan2(there.y - here.y, there.x - here.x)
            turns[other] = abs(math.remainder(towards - yaw, math.tau))
    ahead = min(turns, key=lambda other: turns[other], default="")
    return ends_of(floor, vertex, ahead) if ahead and turns[ahead] <= FACING else None


def _is_held_up(state: FleetState, robot: Robot) -> bool:
    """Tell whether something in front of a robot holds it up by its own fresh report. A robot that stands
    for another reason, be it a broken drive or a failed order, says nothing about its way; nor does one whose
    pose has just jumped."""
    if robot.relocated is not None and state.now - robot.relocated.at < SUSPECT_FOR:
        return False
    return is_blocked_for_long(state, robot)


def blocked_edge(state: FleetState, name: str) -> Ends | None:
    """Return the edge that may be blocked where a robot is held up, None once another one drove over it."""
    found = state.blocked.get(name)
    return found.ends if found is not None and not found.passed else None


def with_blocked_edges(state: FleetState) -> FleetState:
    """Find the edges on which robots are held up, and note which of them others drive over."""
    held = [robot for robot in state.robots.values() if _is_held_up(state, robot)][:MOST_WATCHED]
    if not held:
        return replace(state, blocked={}) if state.blocked else state
    found = {robot.name: state.blocked.get(robot.name) or _begun(robot) for robot in held}
    return replace(
        state, blocked={name: _watched(state, name, one) for name, one in found.items() if one is not None}
    )


def _begun(robot: Robot) -> BlockedEdge | None:
    ends = edge_under(robot)
    return BlockedEdge(ends) if ends is not None else None


def _watched(state: FleetState, name: str, edge: BlockedEdge) -> BlockedEdge:
    if edge.passed:
        return edge
    spans = _spans(state, state.robots[name], edge)
    passed = any(low <= 0.0 and high >= 1.0 for low, high in spans.values())
    return replace(edge, spans=spans, passed=passed)


def _spans(state: FleetState, held: Robot, edge: BlockedEdge) -> Mapping[str, tuple[float, float]]:
    """Return the part of the edge that each other robot on it has driven: 0 and 1 are near its ends."""
    floor, *vertices = edge.ends
    graph = held.maps[floor].graph if floor in held.maps else None
    if graph is None or not graph.vertices.keys() >= set(vertices):
        return {}
    line = [(graph.vertices[one].x, graph.vertices[one].y) for one in vertices]
    spans = {}
    for other in state.robots.values():
        if other is held or other.floor != floor or other.pose is None:
            continue
        at = _share(line, (other.pose.value.x, other.pose.value.y))
        if at is not None and same_frame(state, held, other):
            low, high = edge.spans.get(other.name, (at, at))
            spans[other.name] = min(low, at), max(high, at)
    return spans


def _share(line: Sequence[tuple[float, float]], at: tuple[float, float]) -> float | None:
    """Return how far along a line a place is, between 0 and 1 without what is near its ends; None beside
    it."""
    (x, y), end = line
    length = math.dist(*line)
    if length == 0.0:
        return None
    along = ((at[0] - x) * (end[0] - x) + (at[1] - y) * (end[1] - y)) / length
    beside = abs((at[0] - x) * (end[1] - y) - (at[1] - y) * (end[0] - x)) / length
    near = min(AT_END, length / 3)
    if beside >= ROBOT_WIDTH or not -near <= along <= length + near:
        return None
    return (along - near) / (length - 2 * near)
