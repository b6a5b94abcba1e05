"""The mode of a robot: by its own report, else as this console switched it."""

from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message

MAPPING_MODE = Message("mapping")
NAVIGATION_MODE = "navigation"
"""Words of this console for the two modes. Any other word is the robot's own."""


def is_in_mode(robot: Robot, mapping: bool, since: float | None) -> bool:
    """Tell whether the robot reports to map, or not to, after a monotonic second if that is given."""
    if robot.mode is None or (since is not None and robot.mode.at <= since):
        return False
    return (robot.mode.value == MAPPING_MODE) is mapping


def mapping_text(robot: Robot) -> Message:
    """Return `mapping`, `mapping (by us)` if only this console's own command is known, empty for neither."""
    if robot.mode is not None:
        return MAPPING_MODE if robot.mode.value == MAPPING_MODE else EMPTY
    return Message("{mode} (by us)", mode=MAPPING_MODE) if robot.mapping_by_us else EMPTY
