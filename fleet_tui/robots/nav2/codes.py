"""Error codes of Nav2's results in words (nav2_msgs of Jazzy to Lyrical)."""

from collections.abc import Mapping

from fleet_tui.text.language import N_, Message

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
