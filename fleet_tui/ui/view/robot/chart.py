"""The battery curve, drawn by plotext. Importing it takes a tenth of a second: do that in a thread."""

from collections.abc import Callable, Sequence

import plotext

from fleet_tui.situation.battery.history import BatterySample, runs_of
from fleet_tui.text.ascii_fallback import PLAIN
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run

MARKERS = {Drawing.BRAILLE: "braille", Drawing.HALF_BLOCK: "hd", Drawing.ASCII: "*"}
SPANS = (60.0, 120.0, 300.0, 600.0)
"""Seconds of the narrowest time axes: a young curve fills its own, which changes rarely."""
STEPS = tuple(60 * minutes for minutes in (1, 2, 5, 10, 15, 30, 60, 120, 180, 240, 360, 720))
"""Seconds between two marks of the time axis."""
CELLS_OF_MARK = 9
AXIS = 2
"""Lines of the time axis."""
HOURS_MINUTES = 5


def battery_chart(
    samples: Sequence[BatterySample],
    now: tuple[float, float],
    size: tuple[int, int],
    low: float,
    clock: Callable[[float], str],
    drawing: Drawing,
) -> list[tuple[Run, ...]]:
    """Return the curve until `now` (monotonic and Unix seconds) in lines of `size` (width, height), with its
    axes; `low` is the limit in per cent, `clock` formats Unix seconds as a local time."""
    at, wall = now
    seen = at - samples[0].at if samples else 0.0
    span = next((one for one in SPANS if seen <= one), seen)
    begin = at - span
    plotext.clear_figure()
    plotext.limit_size(False, False)
    plotext.plotsize(*size)
    for run in runs_of(samples):
        times, levels = [one.at - begin for one in run], [one.percent for one in run]
        plotext.plot(times, levels, marker=MARKERS[drawing])
    _draw_axes(span, wall, size[0], low, clock)
    drawn = plotext.uncolorize(plotext.build())
    lines = (drawn.translate(PLAIN) if drawing is Drawing.ASCII else drawn).splitlines()
    return [_roles(line, n < len(lines) - AXIS) for n, line in enumerate(lines)]


def _draw_axes(span: float, wall: float, width: int, low: float, clock: Callable[[float], str]) -> None:
    plotext.xaxes(True, False)
    plotext.yaxes(True, False)
    levels = sorted({0, 50, 100, round(low)})
    plotext.ylim(0, 100)
    plotext.yticks(levels, [f"{level} %" for level in levels])
    marks = _marks(wall - span, wall, width)
    plotext.xlim(0, span)
    plotext.xticks([mark - wall + span for mark in marks], [clock(mark)[:HOURS_MINUTES] for mark in marks])


def _marks(begin: float, end: float, width: int) -> list[float]:
    """Return round times between two Unix seconds, as many as fit."""
    step = next((one for one in STEPS if (end - begin) / one * CELLS_OF_MARK <= width), STEPS[-1])
    first = -int(-begin // step)
    return [float(number * step) for number in range(first, int(end // step) + 1)]


def _roles(line: str, is_plot: bool) -> tuple[Run, ...]:
    """Return a line with a quiet axis."""
    axis = next((n + 1 for n, sign in enumerate(line) if sign in "│┤|+"), 0) if is_plot else len(line)
    return (line[:axis], StyleRole.DIM), (line[axis:], StyleRole.ACCENT)
