"""The time line of a recording: position and events."""

from collections.abc import Callable

from fleet_tui.model.replay import MarkKind, ReplayPosition, TimeMark
from fleet_tui.text.language import tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import percent, span
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, cut, width_of

SAID_FOR = 5.0
"""Recorded seconds for which a mark's text is shown after it was passed."""


MARKS = {
    MarkKind.COMMAND: ("◆", StyleRole.ACCENT),
    MarkKind.GAP: ("╳", StyleRole.WARN),
    MarkKind.ALARM: ("▲", StyleRole.ALARM),
}


def bar(moment: ReplayPosition, width: int) -> tuple[Run, ...]:
    """Return the bar itself, from the first to the last second, at most `width` cells."""
    before, after = _ends(moment)
    cells = width - len(before) - len(after)
    if cells < 3:
        return cut([(before + after, StyleRole.TEXT)], width)
    here = _cell(moment, moment.at, cells)
    signs = [("━", StyleRole.ACCENT) if n < here else ("─", StyleRole.DIM) for n in range(cells)]
    for mark in sorted(moment.marks, key=lambda mark: mark.kind):
        signs[_cell(moment, mark.at, cells)] = MARKS[mark.kind]
    signs[here] = "●", StyleRole.TITLE_FOCUSED
    return ((before, StyleRole.TEXT), *signs, (after, StyleRole.DIM))


def _ends(moment: ReplayPosition) -> tuple[str, str]:
    """Return the texts before and after the bar; their width is constant during play."""
    total = span(moment.ended - moment.began)
    return f" {span(moment.at - moment.began):>{len(total)}} ", f" {total} "


def time_at(moment: ReplayPosition, x: int, width: int) -> float:
    """Return the second of a cell of the time line."""
    before, after = _ends(moment)
    share = (x - len(before)) / max(1, width - len(before) - len(after))
    return moment.began + max(0.0, min(1.0, share)) * (moment.ended - moment.began)


def _cell(moment: ReplayPosition, at: float, cells: int) -> int:
    share = (at - moment.began) / max(moment.ended - moment.began, 1e-9)
    return max(0, min(int(share * cells), cells - 1))


def factor(speed: float) -> str:
    """Return the text of a speed: `x0.25`, `x64`."""
    return f"x{speed:g}"


def _pace(moment: ReplayPosition) -> str:
    if moment.busy is not None:
        return tr("seeking: {percent}", percent=percent(moment.busy))
    if moment.is_over:
        return tr("end of recording")
    reached = (
        tr(" ({factor} reached)", factor=factor(round(moment.reached, 1)))
        if moment.reached is not None
        else ""
    )
    does = tr("stopped") if moment.paused else tr("playing")
    return f"{does} {factor(moment.speed)}{reached}"


def passed(moment: ReplayPosition) -> TimeMark | None:
    """Return the last passed mark, if that was a short while ago."""
    seconds = SAID_FOR * (1.0 if moment.paused else max(1.0, moment.speed))
    recent = [mark for mark in moment.marks if 0.0 <= moment.at - mark.at < seconds]
    return recent[-1] if recent else None


def position_runs(moment: ReplayPosition, clock: Callable[[float], str], width: int) -> tuple[Run, ...]:
    """Return the line below: the play state, and the latest mark."""
    sign = "‖" if moment.paused else "▸"
    runs: list[Run] = [
        (f" {sign} {clock(moment.wall)} ", StyleRole.TEXT),
        (tr("{pace}  read-only  ", pace=_pace(moment)), StyleRole.DIM),
    ]
    mark = passed(moment)
    if mark is not None:
        sign, role = MARKS[mark.kind]
        runs += [(f"{sign} ", role), (f"{translate(sanitize(mark.text))}  ", StyleRole.TEXT)]
    if moment.note:
        runs.append((translate(sanitize(moment.note)), StyleRole.WARN))
    return cut(runs, width) if width_of(runs) > width else tuple(runs)


def time_line(moment: ReplayPosition, clock: Callable[[float], str], width: int) -> list[tuple[Run, ...]]:
    """Return both lines, each exactly `width` cells."""
    return [bar(moment, width), cut(position_runs(moment, clock, width), width)]
