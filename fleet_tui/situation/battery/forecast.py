"""A guess of how long a battery lasts, from how it discharged in the last half hour."""

from collections.abc import Sequence
from itertools import combinations
from statistics import quantiles

from msgspec import Struct

from fleet_tui.situation.battery.history import BatterySample, runs_of

WINDOW = 1800.0
LEAST_SPAN = 600.0
"""Seconds of discharging below which nothing is said."""
LEAST_DROP = 2.0
"""Per cent; less may be the sensor's noise."""
CHARGES = 0.5
"""Per cent of a rise that ends the discharging before it."""
OLD = 120.0
MOST = 60
"""Samples that are compared, each with each other."""
CLEAR = 3.0
"""Times that a fast stretch may be as fast as a slow one; beyond that a line says nothing."""


class BatteryForecast(Struct, frozen=True):
    """Seconds until it is empty, and until it is low, None if it is."""

    empty_in: float
    low_in: float | None


def forecast(samples: Sequence[BatterySample], low: float, now: float) -> BatteryForecast | None:
    """Return a guess from the robust slope (Theil-Sen) of the newest samples, None unless that is clear;
    `low` is the limit in per cent, `now` in monotonic seconds."""
    falling = _falling(samples, now)
    if len(falling) < 3 or falling[-1].at - falling[0].at < LEAST_SPAN:
        return None
    if falling[0].percent - falling[-1].percent < LEAST_DROP:
        return None
    thinned = falling[:: -(-len(falling) // MOST)]
    slopes = [(b.percent - a.percent) / (b.at - a.at) for a, b in combinations(thinned, 2) if b.at > a.at]
    fast, usual, slow = quantiles(slopes, n=4)
    if slow >= 0.0 or fast / slow > CLEAR:
        return None
    level = falling[-1].percent
    return BatteryForecast(level / -usual, (level - low) / -usual if level > low else None)


def _falling(samples: Sequence[BatterySample], now: float) -> list[BatterySample]:
    """Return the newest samples, of the window, without a gap or a rise; none if they are old."""
    runs = runs_of(samples)
    if not runs or runs[-1][-1].at < now - OLD:
        return []
    newest = [sample for sample in runs[-1] if sample.at >= now - WINDOW]
    found: list[BatterySample] = []
    for sample in reversed(newest):
        if found and sample.percent < found[-1].percent - CHARGES:
            break
        found.append(sample)
    return found[::-1]
