"""Bars of robots' activities and curves of values: a cell for each part of the time."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from fleet_tui.model.history.facts import Activity
from fleet_tui.text.language import tr
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run

BARS: Mapping[Activity, tuple[str, str, StyleRole]] = {
    Activity.DRIVING: ("▆", "=", StyleRole.DIM),
    Activity.LOADING: ("▄", "l", StyleRole.ACCENT),
    Activity.WAITING: ("▂", "w", StyleRole.WARN),
    Activity.CHARGING: ("~", "~", StyleRole.ACCENT),
    Activity.IDLE: ("▁", "_", StyleRole.DIM),
    Activity.PAUSED: ("‖", "P", StyleRole.WARN),
    Activity.BLOCKED: ("█", "B", StyleRole.WARN),
    Activity.OFFLINE: ("×", "x", StyleRole.ALARM),
}
"""Glyph, letter where there are no such glyphs, and role of each activity: no two are the same without
colours."""
LEVELS = "▁▂▃▄▅▆▇█"
DIGITS = "01234567"
"""Heights of a curve; the second in ASCII."""


def level(share: float, is_ascii: bool = False) -> str:
    """Return the height of a value in a curve, as a share of the largest, 0 to 1."""
    signs = DIGITS if is_ascii else LEVELS
    return signs[min(len(signs) - 1, max(0, int(share * len(signs))))]


def bars_of(does: Sequence[Activity | None], is_ascii: bool) -> Iterator[Run]:
    """Yield the runs of a bar; a part in which nobody watched is blank."""
    for activity, same in groupby(does):
        glyph, letter, role = BARS[activity] if activity is not None else (" ", " ", StyleRole.TEXT)
        yield (letter if is_ascii else glyph) * len(list(same)), role


def legend_of(bars: Iterable[Iterable[Activity | None]], is_ascii: bool) -> tuple[Run, ...]:
    """Return the sign of each activity that is shown in bars."""
    seen = {activity for does in bars for activity in does}
    return tuple(
        part
        for activity, (glyph, letter, role) in BARS.items()
        if activity in seen
        for part in ((f"  {letter if is_ascii else glyph}", role), (f" {tr(activity.value)}", StyleRole.DIM))
    )
