"""Ages and durations as text: one format for the whole program."""

import math


def age(seconds: float) -> str:
    """Return the text of a duration in seconds: `4 s`, `3 min`, `2 h`; `never` for an infinite one. Minutes
    and hours are whole ones that have passed, from 120 s and 120 min on."""
    if not math.isfinite(seconds):
        return "never"
    whole = round(max(0.0, seconds))
    if whole < 120:
        return f"{whole} s"
    return f"{whole // 60} min" if whole < 7200 else f"{whole // 3600} h"


def duration(seconds: float) -> str:
    """Return the text of a duration whose tenths matter while it is short: `4.2 s`, then as `age`."""
    return f"{max(0.0, seconds):.1f} s" if seconds < 9.95 else age(seconds)
