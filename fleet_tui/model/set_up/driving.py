"""Driving by hand: the speeds of a robot, and the life of a drive."""

from enum import Enum
from typing import NamedTuple


class Axis(Enum):
    """The ways a robot can move by itself, and the field of a Twist for each."""

    AHEAD = "linear.x"
    SIDEWAYS = "linear.y"
    TURNING = "angular.z"


class Speeds(NamedTuple):
    """Metres per second ahead and to the left, radians per second counter-clockwise."""

    ahead: float = 0.0
    sideways: float = 0.0
    turning: float = 0.0


STILL = Speeds()


class DrivePhase(Enum):
    """The life of a drive. It begins once our first zero came back over the bridge."""

    STARTING = "starting"
    READY = "ready"
    ENDED = "ended"


class DriveState(NamedTuple):
    """What the network thread knows of a drive: `sent` is the last frame, `reason` why it ended; `round_trip`
    in seconds, None before the first echo."""

    phase: DrivePhase = DrivePhase.STARTING
    sent: Speeds = STILL
    reason: str = ""
    round_trip: float | None = None
