"""Set-up of robots that navigate: their poses, set from outside."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from fleet_tui.simulator.navigating.poses import FRAME, flat
from fleet_tui.simulator.navigating.robot import NavigatingRobot

Message = dict[str, Any]
Subscriptions = dict[str, tuple[str, Callable[[Message], None]]]
POSE = "geometry_msgs/PoseWithCovarianceStamped"
UNIT = 0.01
"""Deviation of a quaternion from unit length above which it is dropped."""


def initial_poses(robots: Mapping[str, NavigatingRobot]) -> Subscriptions:
    """Return the topic of each robot on which its pose is set."""
    return {f"/{name}/initialpose": (POSE, partial(_take, robot)) for name, robot in robots.items()}


def _take(robot: NavigatingRobot, message: Message) -> None:
    """Take a pose, as amcl does: one in a foreign frame, or without a rotation, is dropped silently."""
    pose = message["pose"]["pose"]
    length = sum(pose["orientation"][axis] ** 2 for axis in "xyzw")
    if message["header"]["frame_id"].lstrip("/") == FRAME and abs(length - 1.0) < UNIT:
        robot.place(flat(pose))
