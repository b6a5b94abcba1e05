"""Costs of the console: its pictures and its process."""

import time
from collections import deque
from collections.abc import Callable
from pathlib import Path

from fleet_tui.model.counters import Flow

KEPT = 100
"""Number of durations for the spread: of ticks, the last 10 s."""


class Durations:
    """The last durations of something."""

    def __init__(self) -> None:
        self._seconds: deque[float] = deque(maxlen=KEPT)

    def take(self, seconds: float) -> None:
        self._seconds.append(seconds)

    def timed(self, work: Callable[[], None]) -> None:
        """Call a function, and add its duration."""
        began = time.perf_counter()
        work()
        self.take(time.perf_counter() - began)

    def spread(self) -> tuple[float, float, float] | None:
        """Return the median, the 95th percentile and the maximum, in seconds; None before the first."""
        ordered = sorted(self._seconds)
        if not ordered:
            return None
        return ordered[len(ordered) // 2], ordered[int(len(ordered) * 0.95)], ordered[-1]


class Budget:
    """Ticks and paintings, bytes sent to the terminal, and the number of delayed pictures."""

    def __init__(self) -> None:
        self.began = time.monotonic()
        self.every = 0.1
        """Seconds from one tick to the next."""
        self.ticks = Durations()
        self.paints = Durations()
        self.sent = Flow()
        self.held = 0


def memory() -> tuple[int, int] | None:
    """Return the bytes of resident memory, and their maximum; None if Linux's /proc is missing.

    VmHWM, not ru_maxrss: that one survives exec.
    """
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
    except OSError:
        return None
    found = {
        name: rest.split()[0] for name, _, rest in (line.partition(":") for line in lines) if rest.split()
    }
    if "VmRSS" not in found or "VmHWM" not in found:
        return None
    return int(found["VmRSS"]) * 1024, int(found["VmHWM"]) * 1024
