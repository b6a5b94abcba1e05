"""What robots themselves say they do: it comes before any guess from their poses."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import STANDS_FOR, STOPS_WITHIN, Goal, ReportedMotion
from fleet_tui.model.order import BEGUN
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import CurrentAction, Vehicle
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import DESPITE_PAUSE, STILL_MOVING, STOPPING, STUCK
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.units import age

STANDS_AFTER = 1.0
"""Seconds without movement after which a robot counts as standing, and within which it counted as moving."""
SELDOM = 2.0
"""Seconds between the poses of robots that nobody looks at, at most by the usual configuration."""
LOCK = Message("Pause it again: that locks its motors")


def _fresh(state: FleetState, robot: Robot) -> Vehicle | None:
    if robot.vehicle is None or not state.is_fresh(robot, "vehicle"):  # asked of every robot in every tick
        return None
    return robot.vehicle.value


def says_driving(state: FleetState, robot: Robot) -> bool | None:
    """Return what a robot says of its movement, None if it says nothing that still holds."""
    vehicle = _fresh(state, robot)
    return vehicle.moves if vehicle is not None else None


def running_action(state: FleetState, robot: Robot) -> CurrentAction | None:
    """Return the action of its order that a robot carries out while it stands."""
    is_busy = robot.acting is not None and says_driving(state, robot) is not True
    return robot.acting if is_busy and _fresh(state, robot) is not None else None


def action_text(state: FleetState, current: CurrentAction) -> Message:
    """Return an action with the time that it has taken so far, as far as that was seen."""
    text = Message("{type}, {age}", type=current.action.type or "action", age=age(state.now - current.since))
    return text if current.is_begin_seen else Message("{text} (seen)", text=text)


def stands_since(robot: Robot, given_at: float) -> bool | None:
    """Tell whether the speeds of a robot show that it stands after a monotonic second, None if it reports
    none."""
    if robot.motion is None:
        return None
    motion = robot.motion.value
    return not motion.is_moving and robot.motion.at - max(motion.since, given_at) >= STANDS_FOR


def stands_with_order(robot: Robot) -> float:
    """Return the seconds for which its poses show it standing, at most since its current order was begun."""
    current = robot.orders.current
    trace = robot.traces.get(current.id) if current is not None else None
    if robot.pose is None or trace is None or trace.began_at is None:
        return robot.still_for
    return min(robot.still_for, max(0.0, robot.pose.at - trace.began_at))


def is_stuck(state: FleetState, robot: Robot) -> bool:
    """Tell whether an alarm holds that it has not moved in spite of its order."""
    return any(alarm.holds and alarm.key == (robot.name, STUCK.name) for alarm in state.alarms)


def waits_for(state: FleetState, robot: Robot) -> float:
    """Return the seconds for which a robot stands with its order: the same in its row, alarm and reasons."""
    if is_stuck(state, robot) and robot.place is not None:
        return state.now - robot.place.at
    return stands_with_order(robot)


def is_moving(robot: Robot, now: float) -> bool:
    """Tell whether its poses showed it moving within the last STANDS_AFTER seconds, or if they come seldom,
    its newest one did."""
    if robot.standing is None:
        return False
    still = now - robot.standing.at
    return still < STANDS_AFTER or (robot.still_for < STANDS_AFTER and still < STANDS_AFTER + SELDOM)


def _driving_goal(state: FleetState, robot: Robot) -> Goal | None:
    """Return another client's goal that drives a robot that was seen to pause: this console keeps back only
    its own ones."""
    if not (robot.kind.holds and robot.paused_by_us and state.is_fresh(robot, "queue")):
        return None
    goals = (goal for listed in robot.goals.values() for goal in listed)
    found = (one for one in goals if one.state in BEGUN and not one.is_ours and not one.is_ending)
    return next(found, None) if _was_seen_to_pause(state, robot) else None


def _was_seen_to_pause(state: FleetState, robot: Robot) -> bool:
    """Tell whether of its pauses and resumes that were confirmed the newest is a pause: a further one may be
    on its way, or have failed."""
    seen = (
        one.command
        for one in reversed(state.commands)
        if one.command.robot == robot.name and one.stage is Stage.CONFIRMED
    )
    newest = next((one for one in seen if isinstance(one, PauseRobot | ResumeRobot)), None)
    return isinstance(newest, PauseRobot)


def moves_despite_pause(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot that is paused does not stand: another client's goal drives it, or by the speeds that
    it reports it brakes, goes on as if there were no pause, or moves again."""
    if not state.is_paused(robot):
        return None
    if (goal := _driving_goal(state, robot)) is not None:
        return Fact(
            DESPITE_PAUSE,
            robot.name,
            DESPITE_PAUSE.word if is_moving(robot, state.now) else Message("another goal despite pause"),
            Priority.MEDIUM,
            goal.begun_at or state.now,
            remedy=Message("Pause it again to cancel that goal, or ask who sends it goals"),
            evidence=Message(
                "another client sent a goal after the pause; a pause holds only this console's goals"
            ),
        )
    if stands_since(robot, 0.0):
        return None
    if robot.motion is not None:
        motion, at = robot.motion.value, robot.motion.at
    elif robot.vehicle is not None and says_driving(state, robot):
        at = robot.vehicle.at
        motion = ReportedMotion(True, 0.0)  # since when its states do not tell
    else:
        return None
    since = state.began.get((robot.name, STOPPING.name), state.now)
    kind, text, priority = STOPPING, STOPPING.word, Priority.LOW
    evidence = Message("the robot has not reported a stop yet")
    if not state.is_online(robot) or state.now - at > state.patience(robot):
        text = Message("not seen to stop")
        evidence = Message("last speed reported {age} ago", age=age(state.now - at))
    elif motion.is_moving and motion.stood and motion.stood > since and at - since > STOPS_WITHIN:
        kind, text, priority, since = DESPITE_PAUSE, DESPITE_PAUSE.word, Priority.MEDIUM, motion.stood
        evidence = Message("it had stopped, and has reported movement for {age}", age=age(at - motion.stood))
    elif motion.is_moving and at - since > STOPS_WITHIN:
        kind, text, priority = STILL_MOVING, STILL_MOVING.word, Priority.HIGH
        evidence = Message("the robot reports movement {age} after the pause", age=age(at - since))
    remedy = LOCK if robot.kind.may_lock and robot.moves_on_since_pause else EMPTY
    return Fact(kind, robot.name, text, priority, since, remedy, evidence=evidence, seen=at)
