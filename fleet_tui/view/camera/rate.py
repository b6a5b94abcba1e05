"""The rate of pictures: halved while they cost the terminal more bytes than allowed."""

import math

from fleet_tui.text.language import tr

EVERY = 0.5
SLOWEST = 8.0
"""Seconds between two pictures, and at the most."""
EARLY = 0.2
"""Part of that time by which a picture may come sooner: networks jitter."""


class PictureRate:
    """Times are monotonic seconds, sizes bytes."""

    def __init__(self, limit: float) -> None:
        """`limit`: bytes a second."""
        self._limit = limit
        self.restart()

    def restart(self) -> None:
        """Forget earlier pictures, and their costs."""
        self.every = EVERY
        self._at = -math.inf
        self._sent = 0

    @property
    def text(self) -> str:
        """Return the rate in words, with the limit that halved it."""
        halved = tr(f" (limit {self._limit / 1000:g} kB/s)") if self.every > EVERY else ""
        return tr(f"{1 / self.every:g} fps{halved}")

    def is_due(self, at: float) -> bool:
        """Tell whether another picture may be shown."""
        return at - self._at >= self.every * (1 - EARLY)

    def take(self, at: float, sent: int) -> None:
        """Take the time at which a picture is shown, and the bytes ever sent to the terminal by then: those
        since the last picture are its cost."""
        if self._at > -math.inf:
            cost = (sent - self._sent) / max(at - self._at, 0.001)
            if cost > self._limit:
                self.every = min(2 * self.every, SLOWEST)
            elif self.every > EVERY and 2 * cost < 0.8 * self._limit:
                self.every /= 2
        self._at = at
        self._sent = sent
