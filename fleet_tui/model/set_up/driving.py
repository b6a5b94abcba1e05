"""Driving by hand: the speeds of a robot, and the life of a drive."""

import math
from enum import Enum
from typing import NamedTuple, Protocol

from fleet_tui.text.language import EMPTY, Message


class Axis(Enum):
    """The ways a robot can move by itself, in the sequence of Speeds."""

    AHEAD = "ahead"
    SIDEWAYS = "sideways"
    TURNING = "turning"


class Speeds(NamedTuple):
    """Metres per second ahead and to the left, radians per second counter-clockwise."""

    ahead: float = 0.0
    sideways: float = 0.0
    turning: float = 0.0

    @property
    def linear(self) -> float:
        """Return the metres per second in whatever direction."""
        return math.hypot(self.ahead, self.sideways)


STILL = Speeds()


class Steering(NamedTuple):
    """The speeds that a hand asks for, and the monotonic second until which it may drive: a screen that
    freezes stops the robot by itself."""

    speeds: Speeds = STILL
    until: float = 0.0


class DrivePhase(Enum):
    """The life of a drive. It begins once our first zero came back over the bridge."""

    STARTING = "starting"
    READY = "ready"
    ENDED = "ended"


class DriveState(NamedTuple):
    """The state of a drive: `sent` is the last frame, `reason` why it ended, `round_trip` that of the latest
    echo in seconds, None before the first one."""

    phase: DrivePhase = DrivePhase.STARTING
    sent: Speeds = STILL
    reason: Message = EMPTY
    round_trip: float | None = None


class HandDrive(Protocol):
    """One drive of one robot by hand. Callable from any thread."""

    @property
    def state(self) -> DriveState:
        """Return the newest state."""

    def steer(self, steering: Steering) -> None:
        """Drive as the hand asks; the newest counts."""

    def end(self, reason: Message) -> None:
        """Stop the robot and end; the first reason counts."""
