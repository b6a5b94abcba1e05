"""A time in equal parts, for pictures and sums."""

import math

from msgspec import Struct

from fleet_tui.records.history.observing import HOUR

EXACT = 48 * HOUR
"""Seconds of a time up to which it is divided exactly; a longer one is divided at full hours."""


class Division(Struct, frozen=True):
    """A time in Unix seconds, divided into `parts`."""

    since: float
    until: float
    parts: int

    @property
    def step(self) -> float:
        """Return the seconds of a part."""
        return (self.until - self.since) / self.parts

    @property
    def is_exact(self) -> bool:
        """Tell whether its parts may begin at any second, instead of full hours."""
        return self.until - self.since <= EXACT

    def part(self, at: float) -> int:
        """Return the part of a moment, counted from 0; one outside the time is in the nearest."""
        return min(self.parts - 1, max(0, int((at - self.since) / self.step)))


def divided(since: float, until: float, most: int) -> Division:
    """Divide a time into at most so many parts; a time of days at full hours of Unix time."""
    if until - since <= EXACT:
        return Division(since, until, most)
    first, last = int(since // HOUR), math.ceil(until / HOUR)
    hours = math.ceil((last - first) / most)
    parts = math.ceil((last - first) / hours)
    return Division(first * HOUR, (first + parts * hours) * HOUR, parts)
