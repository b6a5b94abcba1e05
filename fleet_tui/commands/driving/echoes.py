"""Our own frames as they come back over the bridge: late ones tell a lag, others another publisher."""

from collections.abc import Sequence

from msgspec import Struct

from fleet_tui.model.set_up.driving import STILL, Speeds

OURS_FOR = 1.0
"""Seconds for which a frame with our values is ours, even a second time."""
SAME = 1e-3
"""Metres and radians per second by which an echo may differ."""
MOST = 50
"""Frames that are remembered: those of five seconds."""


class SentTwist(Struct, frozen=True):
    """A frame that left at a monotonic second."""

    speeds: Speeds
    at: float


class Echoes(Struct, frozen=True):
    """The frames without an echo, and those that came back lately; the oldest first."""

    waiting: tuple[SentTwist, ...] = ()
    returned: tuple[SentTwist, ...] = ()
    round_trip: float | None = None
    """Seconds of the latest echo."""

    def sent(self, speeds: Speeds, at: float) -> "Echoes":
        """Note a frame that left."""
        waiting = (*self.waiting, SentTwist(speeds, at))[-MOST:]
        return Echoes(waiting, self.returned, self.round_trip)

    def received(self, speeds: Speeds, at: float) -> "Echoes | None":
        """Take a frame of the topic, None if it is another publisher's. Frames before its own are lost."""
        for index, frame in enumerate(self.waiting):
            if _same(frame.speeds, speeds):
                returned = (*self.returned, *self.waiting[: index + 1])[-MOST:]
                return Echoes(self.waiting[index + 1 :], returned, at - frame.at)
        again = any(at - one.at <= OURS_FOR and _same(one.speeds, speeds) for one in self.returned)
        return self if again else None

    def late(self, at: float) -> float:
        """Return the age of the oldest frame without an echo that moves the robot, in seconds."""
        return max((at - one.at for one in self.waiting if one.speeds != STILL), default=0.0)


def _same(one: Sequence[float], other: Sequence[float]) -> bool:
    return all(abs(mine - theirs) <= SAME for mine, theirs in zip(one, other, strict=True))
