"""The activity of a robot at this moment, in one word."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.robot import Robot
from fleet_tui.rules.why.orders import at_stop
from fleet_tui.rules.why.robot import charges

MOVES_WITHIN = 2.0
"""Seconds without a change of its pose for which a robot still counts as driving: it turns, it brakes."""
OBSTRUCTIONS = frozenset({"stuck", "obstacle", "blocked", "navigation"})
"""Kinds of alarms of a robot that can't drive on."""


def activity(state: FleetState, robot: Robot) -> Activity:
    """Return what a robot does, by its reports that still hold; the first that applies."""
    if not state.is_online(robot):
        return Activity.OFFLINE
    if state.is_paused(robot):
        return Activity.PAUSED
    if _is_blocked(state, robot):
        return Activity.BLOCKED
    if state.is_fresh(robot, "pose") and robot.standing is not None and robot.still_for < MOVES_WITHIN:
        return Activity.DRIVING
    if robot.orders.open:
        return Activity.LOADING if at_stop(state, robot) else Activity.WAITING
    return Activity.CHARGING if charges(state, robot) else Activity.IDLE


def is_told(state: FleetState, robot: Robot) -> bool:
    """Tell whether its activity is known now: not of a robot whose pose is old while others arrive."""
    return not state.is_online(robot) or not state.is_old(robot, "pose")


def _is_blocked(state: FleetState, robot: Robot) -> bool:
    if state.is_obstructed(robot):
        return True
    return any(
        alarm.holds and alarm.condition.source == robot.name and alarm.condition.kind in OBSTRUCTIONS
        for alarm in state.alarms
    )
