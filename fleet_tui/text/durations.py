"""Spans of time as a person reads them: one format for the whole program."""


def age(seconds: float) -> str:
    """A time span as an operator reads it: `4 s`, `3 min`, `2 h`."""
    seconds = max(0.0, seconds)
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.0f} h"
