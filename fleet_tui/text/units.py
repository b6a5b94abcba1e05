"""Sizes, counts and short times as text."""

from fleet_tui.text.durations import duration


def size_text(count: float) -> str:
    """Return bytes as text: `312 B`, `1.2 kB`, `3.4 MB`."""
    if count < 1000:
        return f"{count:.0f} B"
    return f"{count / 1e3:.1f} kB" if count < 1e6 else f"{count / 1e6:.1f} MB"


def ago(at: float | None, now: float) -> str:
    """Return the age of an event, `never` if there was none."""
    if at is None:
        return "never"
    return f"{duration(now - at)} ago"


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
