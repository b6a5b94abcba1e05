"""The activity of a robot at this moment, in one word."""

from collections.abc import Iterable, Set

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.robot import Robot
from fleet_tui.rules.localisation.jumps import is_jumping
from fleet_tui.rules.why.orders import at_stop
from fleet_tui.rules.why.robot import charges

MOVES_WITHIN = 2.0
"""Seconds without a change of its pose for which a robot still counts as driving: it turns, it brakes."""
OBSTRUCTIONS = frozenset({"stuck", "obstacle", "blocked", "navigation"})
"""Kinds of alarms of a robot that can't drive on."""


def activity(state: FleetState, robot: Robot) -> Activity:
    """Return what a robot does, by its reports that still hold; the first that applies."""
    return _activity(state, robot, _blocked(state))


def activities(state: FleetState, robots: Iterable[Robot]) -> dict[str, Activity]:
    """Return what each of these robots does of which that is known now: not of one whose pose is old while
    others arrive."""
    blocked = _blocked(state)
    return {
        robot.name: _activity(state, robot, blocked)
        for robot in robots
        if not state.is_old(robot, "pose") or not state.is_online(robot)
    }


def _activity(state: FleetState, robot: Robot, blocked: Set[str]) -> Activity:
    if not state.is_online(robot):
        return Activity.OFFLINE
    if state.is_paused(robot):
        return Activity.PAUSED
    if robot.name in blocked or state.is_obstructed(robot):
        return Activity.BLOCKED
    drives = robot.standing is not None and robot.still_for < MOVES_WITHIN
    if drives and state.is_fresh(robot, "pose") and not is_jumping(robot, state.now):
        return Activity.DRIVING
    if robot.orders.open:
        return Activity.LOADING if at_stop(state, robot) else Activity.WAITING
    return Activity.CHARGING if charges(state, robot) else Activity.IDLE


def _blocked(state: FleetState) -> Set[str]:
    """Return the robots with an alarm that they can't drive on."""
    conditions = (alarm.condition for alarm in state.alarms if alarm.holds)
    return {condition.source for condition in conditions if condition.kind in OBSTRUCTIONS}
