"""Topics that are due to be subscribed again, because they have been silent for long."""

import random
from collections.abc import Collection, Mapping, Set

# A bridge behind which roscore was restarted stays silent until subscribed again, topic by topic: one that
# another client shares may come back later. A robot that is only switched off is subscribed again repeatedly,
# at doubling intervals. Seconds; a real bridge takes 20 ms for each topic, and has not finished before that.
FIRST_RENEWAL = 8.0
PER_TOPIC = 0.03
LONGEST_INTERVAL = 64.0
RHYTHM = 3.0
"""The multiple of its longest pause so far after which a topic is silent: some batteries report once a
minute."""
# The bridge subscribes in ROS again only when no client holds the topic. Consoles notice a silence at about
# the same time, and unsubscribe for a quarter of the time they waited, up to this many seconds: together.
LONGEST_RELEASE = 8.0


class Renewals:
    """When each of some topics, or groups of them, is subscribed again. Times are monotonic seconds."""

    def __init__(self, names: Collection[str], topics: int) -> None:
        """`topics` is the number of those that the bridge subscribes."""
        self._names = names
        self._first = FIRST_RENEWAL + PER_TOPIC * topics
        self._subscribed_at: dict[str, float] = {}
        self._patience: dict[str, float] = {}
        self._last: dict[str, float] = {}
        self._pauses: dict[str, float] = {}
        """By name: the time of the last message as far as noticed, and the longest pause before one."""

    def start(self, now: float) -> None:
        """Begin to wait: all topics are being subscribed."""
        self._patience.clear()
        self._last.clear()
        self._subscribed_at = dict.fromkeys(self._names, now)

    def due(self, now: float, last_message: Mapping[str, float]) -> tuple[Set[str], float]:
        """Return the names to subscribe again, and for how many seconds to unsubscribe them before;
        `last_message` is by name."""
        silent = {name for name in self._names if self._is_silent(name, now, last_message.get(name, 0.0))}
        if not silent:
            return silent, 0.0
        release_time = min(LONGEST_RELEASE, max(map(self._interval, silent)) / 4)
        for name in silent:
            self._subscribed_at[name] = now
            # A random delay brings consoles together that did not start to wait together.
            self._patience[name] = min(LONGEST_INTERVAL, self._interval(name) * random.uniform(1.8, 2.2))
        return silent, release_time

    def _interval(self, name: str) -> float:
        usual = max(self._first, RHYTHM * self._pauses.get(name, 0.0))
        return self._patience.get(name, min(LONGEST_INTERVAL, usual))

    def _is_silent(self, name: str, now: float, last_message: float) -> bool:
        subscribed_at = self._subscribed_at[name]
        if last_message > subscribed_at:
            self._patience.pop(name, None)
            before = self._last.get(name, subscribed_at)
            if before >= subscribed_at:  # else it was this console that had let go
                self._pauses[name] = max(self._pauses.get(name, 0.0), last_message - before)
            self._last[name] = last_message
        return now - max(last_message, subscribed_at) > self._interval(name)
