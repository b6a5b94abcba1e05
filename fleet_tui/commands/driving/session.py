"""One drive by hand: which frames leave and when it ends. Without a clock or a socket."""

from collections.abc import Sequence

from msgspec import Struct

from fleet_tui.commands.driving.speed import Caps, next_speeds
from fleet_tui.model.set_up.driving import STILL, DrivePhase, DriveState, Speeds, Steering
from fleet_tui.text.language import Message

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


PERIOD = 0.1
"""Seconds between two frames while the robot moves, and between two calls of `tick`."""
RETRY = 0.01
"""Seconds until a frame that could not leave is tried again, as new as it is then."""
ECHO_WITHIN = 1.2
AGAIN = 0.3
"""Seconds for the first echo, and between two of the zeros that wait for it: the first one may be lost."""
LATEST = 0.3
"""Seconds after which an echo is too late to drive on."""
ZEROS = 3
"""Zeros that end a movement; then nothing is sent."""
FOREIGN = Message("someone else drives")
Frames = list[Speeds]


class DriveSession:
    """Decides every frame. Each method takes the monotonic second, and returns the frames to send now."""

    def __init__(self, caps: Caps, topic: str) -> None:
        self._caps = caps
        self._topic = topic
        self._echoes = Echoes()
        self._steering = Steering()
        self._began = self._sent_at = 0.0
        self._zeros = 0
        """Zeros that are still to be sent."""
        self._waits = False
        """Whether a frame is due that could not leave."""
        self.state = DriveState()

    @property
    def is_active(self) -> bool:
        """Tell whether `tick` is due."""
        return self.state.phase is DrivePhase.STARTING or self._moves or self._waits

    @property
    def next_in(self) -> float:
        """Return the seconds until `tick` is due: soon, if a frame could not leave."""
        return RETRY if self._waits else PERIOD

    @property
    def _moves(self) -> bool:
        return self.state.phase is DrivePhase.READY and (self.state.sent != STILL or self._zeros > 0)

    def begin(self, at: float) -> Frames:
        """Begin with a zero, whose echo is awaited."""
        self._began = at
        return self._send(STILL, at)

    def steer(self, steering: Steering, at: float, is_clear: bool) -> Frames:
        """Follow the hand: at once from standstill, and down; otherwise with the next tick. `is_clear`: no
        earlier frame is still on its way, else only zeros leave."""
        self._steering = steering
        stops = not self._asked(at)
        if self.state.phase is DrivePhase.READY and (stops != (self.state.sent == STILL)):
            return self._step(at, is_clear)
        return []

    def tick(self, at: float, is_clear: bool) -> Frames:
        """Send what is due."""
        if self.state.phase is DrivePhase.STARTING:
            if at - self._began > ECHO_WITHIN:
                return self.end(
                    Message(
                        "no echo from {topic} within {seconds} s",
                        topic=self._topic,
                        seconds=f"{ECHO_WITHIN:g}",
                    )
                )
            return self._send(STILL, at) if at - self._sent_at >= AGAIN else []
        return self._step(at, is_clear) if self._moves or self._waits else []

    def received(self, speeds: Speeds, at: float) -> Frames:
        """Take a frame of the topic: an echo of ours, or another publisher's, which ends the drive."""
        if self.state.phase is DrivePhase.ENDED:
            return []
        echoes = self._echoes.received(speeds, at)
        if echoes is None:
            return self.end(FOREIGN)
        self._echoes = echoes
        self.state = self.state._replace(phase=DrivePhase.READY, round_trip=echoes.round_trip)
        return []

    def end(self, reason: Message) -> Frames:
        """End with zeros; the first reason counts."""
        if self.state.phase is DrivePhase.ENDED:
            return []
        self._waits = False
        self.state = self.state._replace(phase=DrivePhase.ENDED, sent=STILL, reason=reason)
        return [STILL] * ZEROS

    def _asked(self, at: float) -> bool:
        return at < self._steering.until and self._steering.speeds != STILL

    def _step(self, at: float, is_clear: bool) -> Frames:
        if self.state.sent != STILL and (late := self._echoes.late(at)) > LATEST:
            return self.end(Message("lag: no echo for {seconds} s", seconds=f"{late:.1f}"))
        target = self._steering.speeds if self._asked(at) else STILL
        seconds = min(at - self._sent_at, PERIOD) if self._moves else PERIOD
        speeds = next_speeds(self.state.sent, target, seconds, self._caps)
        self._waits = speeds != STILL and not is_clear
        if speeds == STILL:
            if self.state.sent != STILL:
                self._zeros = ZEROS
            if not self._zeros:
                return []
            self._zeros -= 1
            return self._send(STILL, at)
        if self._waits:
            return []
        self._zeros = 0
        return self._send(speeds, at)

    def _send(self, speeds: Speeds, at: float) -> Frames:
        self._echoes = self._echoes.sent(speeds, at)
        self._sent_at = at
        self.state = self.state._replace(sent=speeds)
        return [speeds]
