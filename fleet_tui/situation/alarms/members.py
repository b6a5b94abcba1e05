"""Alarm rules for robots of fleets: what their adapter reports about them."""

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.member import ADAPTER_ERROR, EMERGENCY, Member
from fleet_tui.model.robot import Robot
from fleet_tui.situation.alarms.floods import ActiveConditions
from fleet_tui.text.language import EMPTY, Message

FAILED_MODES = frozenset({EMERGENCY, ADAPTER_ERROR})


def issue_text(member: Member) -> Message:
    """Return the first issue of a robot, with the number of others, else a mode in which it can't drive;
    empty for neither."""
    first, *more = (*member.issues, "")
    others = Message(" (and {more} more)", more=len(more) - 1) if len(more) > 1 else ""
    return (
        Message("{first}{others}", first=first, others=others)
        if first
        else member.mode
        if member.mode in FAILED_MODES
        else EMPTY
    )


def issue(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise an alarm while an issue is reported. It is the adapter's: it holds while the robot is offline."""
    text = issue_text(robot.member.value) if robot.member else EMPTY
    if not text:
        return None
    remedy = issue_remedy(state, text)
    return Condition(robot.name, "issue", Priority.MEDIUM, text, Message("no issue reported"), remedy=remedy)


def issue_remedy(state: FleetState, text: str) -> Message:
    """Return what to do about an issue with a lift or a door that it names; empty if it names none."""
    named = next((one.name for one in state.facilities.values() if one.name in text), "")
    return Message("Go to {named}: its power, its network, its mode", named=named) if named else EMPTY


MEMBER_RULES = (issue,)
