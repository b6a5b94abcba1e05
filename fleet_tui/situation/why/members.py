"""Reasons of robots of fleets to stand still: by their driver, their adapter, and an emergency."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.facility import LIFT
from fleet_tui.model.order import OrderState
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import active
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.alarms.facilities import SILENT_AFTER
from fleet_tui.situation.alarms.members import FAILED_MODES, issue_remedy
from fleet_tui.situation.why.reason import LOOK_AT, Reason, Strength
from fleet_tui.text.language import EMPTY, Message, verbatim


def failed_mode(state: FleetState, robot: Robot) -> Reason | None:
    """Report a mode in which it can't drive."""
    if robot.member is None or robot.member.value.mode not in FAILED_MODES:
        return None
    remedy = Message("Check the robot and its fleet adapter")
    return Reason(
        robot.member.value.mode,
        Message("reported by its driver"),
        seen=robot.member.at,
        keys=LOOK_AT,
        remedy=remedy,
    )


def issues(state: FleetState, robot: Robot) -> Reason | None:
    """Report the first issue that its adapter has with it."""
    if robot.member is None or not robot.member.value.issues:
        return None
    first, seen = robot.member.value.issues[0], robot.member.at
    remedy, keys = issue_remedy(state, first) or CLASSES["issue"].action, ("robot_page", "facilities")
    evidence = Message("reported by its fleet adapter")
    return Reason(
        verbatim(first), evidence, Strength.LIKELY, seen=seen, keys=(*keys, *LOOK_AT), remedy=remedy
    )


def emergency(state: FleetState, robot: Robot) -> Reason | None:
    """Report a task that is interrupted and has no token: the end of the emergency resumes it."""
    held = [one for one in active(robot.goals) if one.state is OrderState.PAUSED and not one.tokens]
    if not held:
        return None
    return Reason(
        Message("held by an emergency"), Message("its task continues when that ends"), seen=held[0].listed_at
    )


def lift(state: FleetState, robot: Robot) -> Reason | None:
    """Report the lift that it has, or has called, while it stands for it."""
    own = [one for one in state.facilities.values() if one.sort == LIFT and one.user == robot.name]
    own = [one for one in own if one.link == robot.link and state.now - one.at <= SILENT_AFTER]
    if not own:
        return None
    one = own[0]
    strength = Strength.CERTAIN if one.fault else Strength.LIKELY
    remedy = Message("Put the lift back in service") if one.fault else EMPTY
    return Reason(
        Message("waits for lift {name}", name=one.name), one.state, strength, seen=one.at, remedy=remedy
    )


MEMBER_REASONS = (failed_mode, issues, emergency, lift)
