"""A time axis: marks at round local times."""

from collections.abc import Callable
from xml.etree.ElementTree import Element

from msgspec import Struct

from fleet_tui.features.history.report.html import element
from fleet_tui.records.history.division import Division


class LocalTime(Struct, frozen=True):
    """The time of the site: `offset` is the seconds ahead of UTC; `clock` formats Unix seconds as a time of
    day, or as a date, `moment` as both, with the year or not."""

    offset: float
    clock: Callable[[float, bool], str]
    moment: Callable[[float, bool], str]


MINUTE = 60.0
HOUR = 3600.0
DAY = 86_400.0
STEPS = (
    *(MINUTE * n for n in (1, 2, 5, 10, 15, 30)),
    *(HOUR * n for n in (1, 2, 3, 6, 12)),
    *(DAY * n for n in (1, 2, 7, 14, 30, 90, 365)),
)
EDGE = 20.0
"""Units beside the right edge in which a text is left of its mark."""
MOST = 12
"""Marks of an axis."""


def marks(time: Division, offset: float, most: int = MOST) -> list[float]:
    """Return round times, at most so many; `offset` is the seconds of local time ahead of UTC."""
    span = time.until - time.since
    step = next((one for one in STEPS if span / one <= most), STEPS[-1])
    first = -int(-(time.since + offset) // step)
    last = int((time.until + offset) // step)
    return [number * step - offset for number in range(first, last + 1)]


def axis(time: Division, local: LocalTime, left: float, width: float, height: float) -> list[Element]:
    """Return lines of a height at round times, with their texts below."""
    found: list[Element] = []
    is_long = time.until - time.since > 2 * DAY
    for at in marks(time, local.offset):
        x = left + width * (at - time.since) / (time.until - time.since)
        found.append(element("path", d=f"M{x:.1f},0V{height:.1f}", class_="mark"))
        anchor = "end" if x > left + width - EDGE else "middle"  # else it would be cut there
        found.append(element("text", local.clock(at, is_long), x=x, y=height + 12, text_anchor=anchor))
    return found
