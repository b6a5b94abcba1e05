"""Robots with move_base, recognised by the states of its goals."""

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.move_base.vocabulary import VOCABULARY
from fleet_tui.robots.ros_navigation.discovery import found_at, namespaces, of_robots

STATUS = "move_base/status"
STATUS_TYPE = VOCABULARY.topics["status"][1]
CHOSEN = ("plan", "odometry", "pose", "battery")
"""Topics that differ from site to site."""


def discover(listed: Listed) -> Discovery:
    """Recognise these robots among the names that a bridge lists."""
    there = [name for name, type_ in listed.topics.items() if type_ == STATUS_TYPE]
    spaces = of_robots(namespaces(there, [STATUS]))
    return found_at(spaces, CHOSEN, VOCABULARY, listed)
