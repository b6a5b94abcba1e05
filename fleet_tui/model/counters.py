"""Counters of the wire. They change with every message, so they are not part of the fleet state: the network
loop writes, the screen reads, and neither waits for the other."""

from collections import deque
from collections.abc import Iterable
from functools import partial
from itertools import pairwise
from math import inf
from typing import TypeVar

from msgspec import Struct, structs

from fleet_tui.model.ros_logs import LogLine, PartDiagnosis

WINDOW = 5.0
"""Seconds over which rates are measured."""
MARKS = 6
BEATS = 60
"""Round trips of which the spread is shown: five minutes."""
LARGEST_KEPT = 1_000_000
"""Maximum bytes of a message that is kept whole; of a larger one only the beginning is."""
HEAD = 4096
LOG_LINES = 500
"""Number of lines of the robots' log that are kept."""
MOST_DIAGNOSES = 500
"""Number of names for which diagnostics are kept."""


T = TypeVar("T")


def snapshot(newest: deque[T]) -> tuple[T, ...]:
    """Return a copy, though another thread may be adding to it."""
    while True:
        try:
            return tuple(newest)
        except RuntimeError:  # it changed during the copy
            continue


class Flow:
    """A repeated event: its count and size. Times are monotonic seconds.

    A rate is that of the last WINDOW seconds; a mark once a second records the counts.
    """

    __slots__ = ("_mark", "_marks", "at", "bytes", "count")

    def __init__(self) -> None:
        self.count = self.bytes = 0
        self.at: float | None = None
        """The time of the last message."""
        self._marks: deque[tuple[float, int, int]] = deque(maxlen=MARKS)
        self._mark = -inf

    def take(self, size: int, at: float) -> None:
        """Count one more, of this many bytes."""
        self.count += 1
        self.bytes += size
        self.at = at
        if not self._mark <= at < self._mark + 1.0:
            if at < self._mark:
                self._marks.clear()  # a recording was turned back
            self._mark = at
            self._marks.append((at, self.count, self.bytes))

    def rates(self, now: float) -> tuple[float, float] | None:
        """Messages and bytes a second; None after at most one arrival."""
        if self.at is None or self.count < 2:
            return None
        for at, count, size in snapshot(self._marks):
            if at >= now - WINDOW and self.count > count:
                # Between n arrivals lie n - 1 gaps. A silence longer than such a gap counts, too.
                gaps, span = self.count - count, max(self.at - at, 1e-9)
                span = max(span, now - at - span / gaps)
                return gaps / span, (self.bytes - size) / span
        return 0.0, 0.0


class Raw(Struct, frozen=True, gc=False):
    """A frame as it arrived, or the beginning of a large one; `size` is that of the whole."""

    payload: bytes
    is_binary: bool
    at: float
    size: int

    @property
    def is_whole(self) -> bool:
        """Tell whether all of it was kept."""
        return len(self.payload) == self.size


class BadMessage(Struct, frozen=True):
    """A message that could not be read, and the reason."""

    text: str
    raw: Raw


class TopicCounter(Flow):
    """One topic. `robot` and `kind` are empty for the robots' log and diagnostics; `once`: it arrives once,
    `on_demand`: only while its floor is shown, `on_change`: only then."""

    __slots__ = (
        "asked_ms",
        "bad",
        "errors",
        "kind",
        "last",
        "not_subscribed",
        "on_change",
        "on_demand",
        "once",
        "robot",
        "topic",
    )

    def __init__(
        self,
        topic: str,
        robot: str = "",
        kind: str = "",
        once: bool = False,
        on_demand: bool = False,
        on_change: bool = False,
    ) -> None:
        super().__init__()
        self.topic = topic
        self.robot = robot
        self.kind = kind
        self.once = once
        self.on_demand = on_demand
        self.on_change = on_change
        self.errors = 0
        self.asked_ms: int | None = None
        """The milliseconds between two messages that were requested, None before."""
        self.last: Raw | None = None
        self.bad: BadMessage | None = None
        self.not_subscribed = ""
        """The reason that it is not subscribed, empty if it is."""

    def count_frame(self, payload: bytes, is_binary: bool, at: float) -> None:
        size = len(payload)
        self.take(size, at)
        kept = payload if size <= LARGEST_KEPT else payload[:HEAD]
        self.last = Raw(kept, is_binary, at, size)

    def failed(self, text: str, raw: Raw | None = None) -> None:
        """Count a frame (default: the latest) that could not be read completely."""
        self.errors += 1
        found = raw or self.last
        if found is not None:
            self.bad = BadMessage(text, found)


class RoundTrips:
    """The durations of the heartbeat's calls, in seconds."""

    def __init__(self) -> None:
        self._took: deque[float] = deque(maxlen=BEATS)
        self.at: float | None = None
        self.unanswered = 0

    def take(self, seconds: float, at: float) -> None:
        """Count an answer."""
        self._took.append(seconds)
        self.at = at

    @property
    def took(self) -> tuple[float, ...]:
        """The latest durations, newest last."""
        return snapshot(self._took)

    @property
    def jitter(self) -> float:
        """Mean difference of consecutive durations."""
        took = self.took
        return sum(abs(b - a) for a, b in pairwise(took)) / max(1, len(took) - 1)


def _is_same_line(one: LogLine, other: LogLine) -> bool:
    return one.stamp == other.stamp and one.node == other.node and one.text == other.text


class LinkCounter:
    """One bridge."""

    def __init__(self, name: str, topics: Iterable[TopicCounter]) -> None:
        self.name = name
        self.topics = {topic.topic: topic for topic in topics}
        """The subscribed topics in their order. With further robots there is a new mapping."""
        self.all = Flow()
        """Every frame on the connection for telemetry."""
        self.round_trips = RoundTrips()
        self.connections = 0
        self.lost_at: float | None = None
        self.lost_why = ""
        self.dropped = 0
        """Frames that were passed over, being too large or too many."""
        self.overtaken = 0
        """Frames that were not decoded: a newer one of their topic had come while this console was behind."""
        self.unreadable = 0
        """Frames of which not even the topic could be read."""
        self.bad: BadMessage | None = None
        """The newest of them."""
        self.log: deque[LogLine] = deque(maxlen=LOG_LINES)
        self.logged = 0
        """The number of lines of the robots' log received so far."""
        self.health: dict[str, PartDiagnosis] = {}
        self._is_up = False

    def opened(self) -> None:
        """Count a connection."""
        self.connections += 1
        self._is_up = True

    def lost(self, why: str, at: float) -> None:
        """Count a lost connection. Later attempts that fail don't count."""
        if self._is_up:
            self._is_up = False
            self.lost_at = at
            self.lost_why = why

    def keep_one_map(self, newest: TopicCounter) -> None:
        """Of all on-demand messages, keep the newest whole and only the beginnings of the others."""
        for topic in self.topics.values():
            if topic.on_demand and topic is not newest and topic.last is not None:
                topic.last = structs.replace(topic.last, payload=topic.last.payload[:HEAD])

    def failed(self, text: str, payload: bytes, is_binary: bool, at: float) -> None:
        """Count a frame that could not be read at all."""
        self.unreadable += 1
        self.bad = BadMessage(text, Raw(payload[:HEAD], is_binary, at, len(payload)))

    def take_log(self, line: LogLine) -> bool:
        """Keep a line of the robots' log, and tell whether it is new: /rosout is latched, and sends its last
        ones again."""
        if line.stamp is not None and any(map(partial(_is_same_line, line), self.log)):
            return False
        self.logged += 1
        self.log.append(line)
        return True

    def take_health(self, diagnoses: Iterable[PartDiagnosis]) -> None:
        """Keep the robots' diagnostics, the newest of each name."""
        health = dict(self.health)
        for one in diagnoses:
            if one.name in health or len(health) < MOST_DIAGNOSES:
                health[one.name] = one
        self.health = health  # swapped whole: another thread may be reading
