"""Error codes of Nav2's results in words (nav2_msgs of Jazzy to Lyrical)."""

from collections.abc import Mapping

CODES: Mapping[int, str] = {
    101: "invalid controller plugin",
    102: "transform missing for the controller",
    103: "invalid path for the controller",
    104: "controller patience exceeded",
    105: "no progress",
    106: "no valid control",
    107: "controller timed out",
    201: "invalid planner plugin",
    202: "transform missing for the planner",
    203: "start off the map",
    204: "goal off the map",
    205: "start occupied",
    206: "goal occupied",
    207: "planner timed out",
    208: "no path to the goal",
    600: "waypoint server failed",
    601: "waypoint task failed",
    602: "no waypoints",
    603: "waypoint missed",
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


def error_text(code: int, message: str = "") -> str:
    """Return the meaning of an error code, the code, and the robot's own message."""
    known = CODES.get(code) or _GROUPS.get(code // 100, "")
    if code >= 9000:
        known = "navigator failed"
    said = f": {message}" if message else ""
    return (f"{known} (error {code})" if known else f"error {code}") + said
