"""Error codes of Nav2's results in words (nav2_msgs of Jazzy to Lyrical)."""

from collections.abc import Mapping

CODES: Mapping[int, str] = {
    101: "the controller got an invalid plugin",
    102: "a transform is missing for the controller",
    103: "the controller got an invalid path",
    104: "the controller ran out of patience",
    105: "it makes no progress",
    106: "the controller found no way to move",
    107: "the controller ran out of time",
    201: "the planner got an invalid plugin",
    202: "a transform is missing for the planner",
    203: "it stands off the map",
    204: "the goal is off the map",
    205: "it stands on occupied ground",
    206: "the goal is on occupied ground",
    207: "the planner ran out of time",
    208: "no path leads to the goal",
    600: "the waypoint server failed",
    601: "the waypoint task failed",
    602: "no waypoint was given",
    603: "a waypoint was missed",
}

_GROUPS: Mapping[int, str] = {
    1: "controller",
    2: "planner",
    3: "planner through poses",
    4: "route server",
    5: "smoother",
    6: "waypoint server",
    7: "behaviour",
    9: "docking or navigation",
}


def in_words(code: int, message: str = "") -> str:
    """Write an error code with what it means, and the robot's own message."""
    known = CODES.get(code) or _GROUPS.get(code // 100, "")
    if code >= 9000:
        known = "the navigator failed"
    said = f": {message}" if message else ""
    return f"error {code}{f' ({known})' if known else ''}{said}"
