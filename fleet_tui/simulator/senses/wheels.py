"""Wheels that follow twists, as a hand at a console sends them. No wall stops them. Pure."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, Protocol

from fleet_tui.model.geometry import Pose

Message = dict[str, Any]

TOPIC = "cmd_vel"
STAMPED = "cmd_vel_stamped"
TIMEOUT = 0.5  # seconds without a twist after which a robot stops


class Wheels:
    """The speeds asked for last, and their age. `timeout` may be changed."""

    timeout = TIMEOUT
    driven = 0.0
    """Seconds that it moved by twists."""

    def __init__(self) -> None:
        self.speeds = Pose(0.0, 0.0)
        """Metres per second ahead and to the left, radians per second."""
        self.age = math.inf
        """Seconds since the last twist."""

    def take(self, twist: Message) -> None:
        """Take a geometry_msgs/Twist."""
        linear, angular = twist["linear"], twist["angular"]
        self.speeds = Pose(linear["x"], linear["y"], angular["z"])
        self.age = 0.0

    def carry(self, pose: Pose, seconds: float) -> Pose:
        """Return the pose some seconds later."""
        self.age += seconds
        if self.age > self.timeout:
            self.speeds = Pose(0.0, 0.0)
        if self.speeds == Pose(0.0, 0.0):
            return pose
        self.driven += seconds
        return pose.after(
            Pose(*(speed * seconds for speed in (self.speeds.x, self.speeds.y, self.speeds.yaw)))
        )


class Wheeled(Protocol):
    """A robot with wheels."""

    wheels: Wheels


def twists(robots: Mapping[str, Wheeled]) -> dict[str, tuple[str, Callable[[Message], None]]]:
    """Return the topics of each robot on which it takes twists, with and without a stamp."""
    found = dict[str, tuple[str, Callable[[Message], None]]]()
    for name, robot in robots.items():
        found[f"/{name}/{TOPIC}"] = ("geometry_msgs/Twist", robot.wheels.take)
        found[f"/{name}/{STAMPED}"] = ("geometry_msgs/TwistStamped", partial(_take_stamped, robot.wheels))
    return found


def _take_stamped(wheels: Wheels, message: Message) -> None:
    wheels.take(message["twist"])
