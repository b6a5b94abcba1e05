"""Answers of Nav2's action servers: their meaning for a command."""

from collections.abc import Mapping
from typing import Any

from fleet_tui.model.commands import Command, PauseRobot, Stage
from fleet_tui.robots.service_outcome import judge, said
from fleet_tui.text.language import EMPTY, N_, Message, counted, joined, verbatim
from fleet_tui.text.limits import truncate

CODES: Mapping[int, str] = {
    101: N_("invalid controller plugin"),
    102: N_("transform missing for the controller"),
    103: N_("invalid path for the controller"),
    104: N_("controller patience exceeded"),
    105: N_("no progress"),
    106: N_("no valid control"),
    107: N_("controller timed out"),
    201: N_("invalid planner plugin"),
    202: N_("transform missing for the planner"),
    203: N_("start off the map"),
    204: N_("goal off the map"),
    205: N_("start occupied"),
    206: N_("goal occupied"),
    207: N_("planner timed out"),
    208: N_("no path to the goal"),
    600: N_("waypoint server failed"),
    601: N_("waypoint task failed"),
    602: N_("no waypoints"),
    603: N_("waypoint missed"),
}

_GROUPS: Mapping[int, str] = {
    1: N_("controller"),
    2: N_("planner"),
    3: N_("planner through poses"),
    4: N_("route server"),
    5: N_("smoother"),
    6: N_("waypoint server"),
    7: N_("behaviour"),
    9: N_("docking or navigation"),
}


def error_text(code: int, message: str = "") -> Message:
    """Return the meaning of an error code, the code, and the robot's own message."""
    known = N_("navigator failed") if code >= 9000 else CODES.get(code) or _GROUPS.get(code // 100, "")
    text = Message("error {code}", code=code)
    if known:
        text = Message("{text} (error {code})", text=Message(known), code=code)
    return Message("{text}: {message}", text=text, message=message) if message else text


RETURN_CODES = {
    1: Message("rejected by the robot"),
    2: Message("goal unknown to the robot"),
    3: Message("goal already ended"),
}
"""Return codes of action_msgs/CancelGoal."""
NO_SERVER = ("does not exist", "No action server available")


def judge_cancel(command: Command, values: object, result: bool) -> tuple[Stage, Message]:
    """Judge the answer to a cancellation. One of all goals succeeds if there are none."""
    all_meant = isinstance(command, PauseRobot)
    if not result:
        stage, detail = judge(command, values, result, ())
        absent = stage is Stage.REFUSED and any(text in detail for text in NO_SERVER)
        return (Stage.ACCEPTED, Message("no action server")) if all_meant and absent else (stage, detail)
    code = values.get("return_code") if isinstance(values, Mapping) else None
    if not isinstance(code, int):
        return Stage.UNKNOWN, Message("unrecognised reply: {reply}", reply=truncate(said(values)))
    if code == 0:
        return Stage.ACCEPTED, EMPTY
    detail = RETURN_CODES.get(code) or Message("return code {code}", code=code)
    well = code == 3 or (all_meant and code in (1, 2))
    return (Stage.ACCEPTED, Message("no goal active")) if well else (Stage.REFUSED, detail)


def judge_goal(values: object, status: int, result: bool) -> tuple[Stage, Message]:
    """Judge the end of a goal that this console gave, as far as its own answer shows."""
    if not result:
        return Stage.REFUSED, verbatim(truncate(said(values)))
    fields: Mapping[str, Any] = values if isinstance(values, Mapping) else {}
    missed = fields.get("missed_waypoints")
    if isinstance(missed, list) and missed:
        causes = (_error(stop) for stop in (*missed, fields) if isinstance(stop, Mapping))
        count = counted("{count} stop missed", "{count} stops missed", len(missed))
        return Stage.FAILED, joined("; ", filter(None, (next(filter(None, causes), ""), count)))
    return (Stage.DONE if status == 4 else Stage.FAILED), _error(fields)


def _error(fields: Mapping[str, Any]) -> Message:
    """Return the error code and message of a result or of a missed waypoint, empty without a code."""
    code, message = fields.get("error_code"), fields.get("error_msg")
    if not isinstance(code, int) or not code:
        return EMPTY
    return error_text(code, truncate(message) if isinstance(message, str) else "")
