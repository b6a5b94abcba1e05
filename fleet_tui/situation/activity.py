"""The activity of a robot at this moment, in one word."""

from collections.abc import Iterable, Set

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.trouble import halting_fact, is_halted
from fleet_tui.situation.battery.charging import charging_reported
from fleet_tui.situation.facts import AGE_UNKNOWN, BAD_DATA, INACTIVE, OBSTACLE, STOP, STUCK
from fleet_tui.situation.pauses import is_held
from fleet_tui.situation.pose_checks.jumps import is_jumping
from fleet_tui.situation.reported_motion import is_stuck, running_action, says_driving
from fleet_tui.situation.robots import absence
from fleet_tui.situation.why.orders import at_stop
from fleet_tui.situation.why.robot import charges
from fleet_tui.text.language import Message

MOVES_WITHIN = 2.0
"""Seconds without a change of its pose for which a robot still counts as driving: it turns, it brakes."""
BEGINS_FOR = 5.0
"""Seconds of a link in which a pose may be the first one."""
OBSTRUCTED = Message("obstacle")
BLOCKED = Message("blocked")
LOADS = frozenset({"pick", "drop"})
"""Types of actions that load and unload."""
OBSTRUCTIONS = frozenset(kind.name for kind in (STUCK, OBSTACLE, STOP, INACTIVE))
"""Kinds of alarms of a robot that can't drive on."""


def activity(state: FleetState, robot: Robot) -> Activity:
    """Return what a robot does, by its reports that still hold; the first that applies."""
    return _activity(state, robot, _blocked(state), _kept(state))


def activities(state: FleetState, robots: Iterable[Robot]) -> dict[str, Activity]:
    """Return what each of these robots does of which that is known now."""
    blocked, kept = _blocked(state), _kept(state)
    found = ((robot, _activity(state, robot, blocked, kept)) for robot in robots)
    return {robot.name: does for robot, does in found if _is_known(state, robot, does)}


def _activity(state: FleetState, robot: Robot, blocked: Set[str], kept: Set[str]) -> Activity:
    if not state.is_online(robot):
        return Activity.OFFLINE
    if is_held(state, robot):
        return Activity.PAUSED
    if robot.name in blocked or is_halted(state, robot):
        return Activity.BLOCKED
    says = says_driving(state, robot)
    if says:
        return Activity.DRIVING
    if charging_reported(state, robot) is not None:
        return Activity.CHARGING
    drives = says is None and robot.standing is not None and robot.still_for < MOVES_WITHIN
    # The first pose of one without an order is no movement.
    begins = robot.orders.current is None and state.now - state.links[robot.link].since < BEGINS_FOR
    if drives and not begins and state.is_fresh(robot, "pose") and not is_jumping(robot, state.now):
        return Activity.DRIVING
    if (action := running_action(state, robot)) is not None:
        return Activity.LOADING if action.action.type in LOADS else Activity.WAITING
    if robot.orders.open or robot.name in kept:
        return Activity.LOADING if at_stop(state, robot) else Activity.WAITING
    return Activity.CHARGING if charges(state, robot) else Activity.IDLE


def halt_word(state: FleetState, robot: Robot) -> Message:
    """Return what keeps a robot that is blocked: the word of its row and of the counts."""
    fact = halting_fact(state, robot)
    if fact is None:
        return STUCK.word if is_stuck(state, robot) else BLOCKED
    if fact.kind is OBSTACLE:
        return OBSTRUCTED
    return BLOCKED if fact.kind is STOP else fact.kind.word


def may_do_anything(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot speaks, and nothing of that tells what it does now."""
    fact = absence(state, robot)
    return fact is not None and fact.kind in (AGE_UNKNOWN, BAD_DATA) and not state.is_online(robot)


def _is_known(state: FleetState, robot: Robot, does: Activity) -> bool:
    """Tell whether fresh reports show what a robot does: its pose that it stands, its queue why."""
    if may_do_anything(state, robot):
        return False
    if does in (Activity.OFFLINE, Activity.PAUSED) or is_halted(state, robot):
        return True
    if (
        says_driving(state, robot) is None
        and "pose" in robot.kind.reports
        and not state.is_fresh(robot, "pose")
    ):
        return False
    if does in (Activity.DRIVING, Activity.BLOCKED) or state.is_fresh(robot, "queue"):
        return True
    # Some kinds report orders only once there is one.
    return robot.queue is None and robot.kind.lists_orders and not robot.kind.expects("queue")


def _kept(state: FleetState) -> Set[str]:
    """Return the robots for which an order waits in this console."""
    return {record.command.robot for record in state.commands if record.stage is Stage.WAITING}


def _blocked(state: FleetState) -> Set[str]:
    """Return the robots with an alarm that they can't drive on."""
    conditions = (alarm.condition for alarm in state.alarms if alarm.holds)
    return {condition.source for condition in conditions if condition.kind in OBSTRUCTIONS}
