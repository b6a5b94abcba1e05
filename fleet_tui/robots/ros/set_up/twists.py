"""Speeds as geometry_msgs/Twist or TwistStamped, and back."""

import math
from collections.abc import Mapping

import msgspec

from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.robots.ros.messages import reader
from fleet_tui.robots.ros.set_up.names import STAMPED_TWIST, TWIST
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import WireError

FRAME = "base_link"


class _Vector(msgspec.Struct):
    x: float = math.nan
    y: float = math.nan
    z: float = math.nan


class Twist(msgspec.Struct):
    """A Twist as it comes; a value that is not sent is no number."""

    linear: _Vector
    angular: _Vector


class StampedTwist(msgspec.Struct):
    """A TwistStamped, of which only the twist counts."""

    twist: Twist


_read = reader(Twist)
_read_stamped = reader(StampedTwist)


def is_stamped(type_: str) -> bool | None:
    """Tell whether twists of a type have a header, None if the type is another one."""
    return True if same_type(type_, STAMPED_TWIST) else False if same_type(type_, TWIST) else None


def twist_message(speeds: Speeds, stamped: bool) -> Mapping[str, object]:
    """Return the message of speeds. Without a stamp: the bridge fills in its own time, ours may be off."""
    twist = {
        "linear": {"x": speeds.ahead, "y": speeds.sideways, "z": 0.0},
        "angular": {"x": 0.0, "y": 0.0, "z": speeds.turning},
    }
    return {"header": {"frame_id": FRAME}, "twist": twist} if stamped else twist


def read_twist(message: object, stamped: bool) -> Speeds:
    """Return the speeds of a message, still encoded. Raises WireError."""
    twist = _read_stamped(message).twist if stamped else _read(message)
    speeds = Speeds(twist.linear.x, twist.linear.y, twist.angular.z)
    others = (twist.linear.z, twist.angular.x, twist.angular.y)
    if not all(map(math.isfinite, (*speeds, *others))):
        raise WireError("a twist that is not finite")
    return speeds
