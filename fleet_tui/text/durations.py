"""Ages and durations as text: one format for the whole program."""

import math


def age(seconds: float) -> str:
    """Return the text of a duration in seconds: `4 s`, `3 min`, `2 h`; `never` for an infinite one."""
    if not math.isfinite(seconds):
        return "never"
    seconds = max(0.0, seconds)
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.0f} h"
