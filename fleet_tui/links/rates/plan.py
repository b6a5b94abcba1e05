"""Changes of intervals, spread over time: a faster one at once, a slower one later, and few in a second."""

from collections.abc import Callable, Iterator, Mapping
from math import inf

from fleet_tui.model.attention import Intervals

HOLD = 5.0
"""Seconds for which a robot keeps a faster rate that is no longer needed: one pans back and forth."""


class RatePlan:
    """The requested intervals of each robot. `per_second`: topics whose subscription may change in a second.
    `topics`: how many of a robot's topics a change is about. Times are seconds of any clock."""

    def __init__(self, per_second: int, topics: Callable[[str, Intervals, Intervals], int]) -> None:
        self._per_second = per_second
        self._topics = topics
        self.asked: dict[str, Intervals] = {}
        self._needed_at: dict[str, float] = {}
        """When each robot's intervals were needed last."""
        self._left = 0.0
        self._at = inf

    def begin(self, wanted: Mapping[str, Intervals], now: float) -> None:
        """Request these intervals: nothing is subscribed yet."""
        self.asked = {}
        self._needed_at = {}
        self.extend(wanted, now)
        self._left = float(self._per_second)
        self._at = now

    def extend(self, asked: Mapping[str, Intervals], now: float) -> None:
        """Add robots that are subscribed at these intervals."""
        self.asked.update(asked)
        self._needed_at.update(dict.fromkeys(asked, now))

    def due(self, wanted: Mapping[str, Intervals], now: float) -> list[tuple[str, Intervals]]:
        """Change the intervals that may change now, the fastest first, and return their robots with the
        earlier ones."""
        # A robot with many topics may exceed what is left: then the next changes wait for that, too.
        self._left = min(self._per_second, self._left + self._per_second * max(0.0, now - self._at))
        self._at = now
        changed = []
        for robot, intervals in sorted(self._changes(wanted, now), key=lambda one: one[1]):
            if self._left <= 0:
                break
            before, self.asked[robot] = self.asked[robot], intervals
            self._needed_at[robot] = now
            self._left -= self._topics(robot, before, intervals)
            changed.append((robot, before))
        return changed

    def _changes(self, wanted: Mapping[str, Intervals], now: float) -> Iterator[tuple[str, Intervals]]:
        for robot, new in wanted.items():
            old = self.asked[robot]
            if new == old:
                self._needed_at[robot] = now
                continue
            if now - self._needed_at[robot] < HOLD:
                new = Intervals(*map(min, old, new))
            if new != old:
                yield robot, new
