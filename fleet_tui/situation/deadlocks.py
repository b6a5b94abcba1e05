"""Two robots that wait for each other: neither can drive on before the other one does."""

import math
from itertools import combinations, pairwise

from msgspec.structs import replace

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import Deadlock, FleetState
from fleet_tui.model.geometry import Line, metres_from
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.trouble import is_halted
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import DEADLOCK
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.reported_motion import running_action, says_driving, stands_with_order
from fleet_tui.situation.traffic import AT_VERTEX, ROBOT_WIDTH, points_ahead, same_frame
from fleet_tui.text.language import Message

IN_REACH = 3.0
"""Metres from a robot's next edge within which another one keeps it waiting."""
STANDS_FOR = 5.0
"""Seconds of standing with an order before which robots may just give way to each other."""


def with_deadlocks(state: FleetState, before: float) -> FleetState:
    """Find the robots that wait for each other, once a second: `before` is the time of the last tick."""
    if math.floor(state.now) == math.floor(before):
        return state
    ways = {robot.name: way for robot in state.robots.values() if (way := _way_wanted(state, robot))}
    found: dict[str, Deadlock] = {}
    for one, other in combinations([state.robots[name] for name in ways], 2):
        is_mutual = _hold_each_other(one, ways[one.name][0], other, ways[other.name][0])
        if not is_mutual or not same_frame(state, one, other):
            continue
        stood = min(stands_with_order(one), stands_with_order(other))
        for robot, partner in ((one, other.name), (other, one.name)):
            known = state.deadlocks.get(robot.name)
            goes_on = known is not None and known.other == partner
            since = known.since if known is not None and goes_on else state.now - stood
            if goes_on or robot.name not in found:
                found[robot.name] = Deadlock(partner, since, ways[robot.name])
    return replace(state, deadlocks=found) if found or state.deadlocks else state


def _way_wanted(state: FleetState, robot: Robot) -> tuple[Line, ...]:
    """Return the next edges of a robot that stands with an order for no reason of its own; empty for others,
    and at its stop."""
    if robot.orders.current is None or robot.pose is None or stands_with_order(robot) < STANDS_FOR:
        return ()
    if not state.is_fresh(robot, "pose") or is_held(state, robot) or is_halted(state, robot):
        return ()
    if says_driving(state, robot) or running_action(state, robot) is not None:
        return ()
    here, *ahead = points_ahead(robot) or [(0.0, 0.0)]
    beyond = [point for point in ahead if math.dist(point, here) > AT_VERTEX]
    return tuple((*start, *end) for start, end in pairwise([here, *beyond]))


def _hold_each_other(one: Robot, edge: Line, other: Robot, other_edge: Line) -> bool:
    """Tell whether each robot is ahead of the other one, beside its next edge, and these edges meet:
    robots of two lanes pass, and of two in a row only one waits."""
    if not (_is_before(other, edge) and _is_before(one, other_edge)):
        return False
    ends = [(edge[:2], other_edge), (edge[2:], other_edge), (other_edge[:2], edge), (other_edge[2:], edge)]
    return min(metres_from(at, line) for at, line in ends) <= ROBOT_WIDTH


def _is_before(robot: Robot, edge: Line) -> bool:
    assert robot.pose is not None
    x, y, to_x, to_y = edge
    at = robot.pose.value.x, robot.pose.value.y
    is_ahead = (at[0] - x) * (to_x - x) + (at[1] - y) * (to_y - y) > 0.0
    return is_ahead and metres_from(at, edge) <= IN_REACH


def deadlock(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot waits for one that waits for it."""
    found = state.deadlocks.get(robot.name)
    other = state.robots.get(found.other) if found is not None else None
    if found is None or other is None or robot.pose is None or other.pose is None:
        return None
    here, there = robot.pose.value, other.pose.value
    return Fact(
        DEADLOCK,
        robot.name,
        Message("waits for {name}, which waits for it", name=other.name),
        Priority.MEDIUM,
        found.since,
        evidence=Message(
            "{metres} m apart, each stands on the other's next edge",
            metres=f"{math.dist((here.x, here.y), (there.x, there.y)):.1f}",
        ),
        seen=other.pose.at,
    )
