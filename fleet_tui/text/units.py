"""Sizes, counts and short times as text."""

import math

from fleet_tui.text.language import Message


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


def size_text(count: float) -> str:
    """Return bytes as text: `312 B`, `1.2 kB`, `3.4 MB`."""
    if count < 1000:
        return f"{count:.0f} B"
    return f"{count / 1e3:.1f} kB" if count < 1e6 else f"{count / 1e6:.1f} MB"


def ago(at: float | None, now: float) -> Message:
    """Return the age of an event, `never` if there was none."""
    if at is None:
        return Message("never")
    return Message("{duration} ago", duration=duration(now - at))


def milliseconds(seconds: float) -> str:
    """Return a short duration: `0.42 ms`, `12 ms`."""
    found = seconds * 1000
    return f"{found:.2f} ms" if found < 10 else f"{found:.0f} ms"


def percent(share: float) -> str:
    """Return a share of 1 as text: `4 %`."""
    return f"{share * 100:.0f} %"


def counted(count: int, one: str, many: str = "") -> str:
    """Return a count with its noun: `1 error`, `2 vertices`."""
    return f"{count} {one if count == 1 else many or f'{one}s'}"


def span(seconds: float) -> str:
    """Return a span as on a player: `4:31`, `1:04:31`."""
    minutes, rest = divmod(int(max(0.0, seconds)), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
