"""The battery curve: gaps stay gaps, the axis has local times, in every drawing mode."""

from itertools import pairwise

import pytest

from fleet_tui.situation.battery.history import BatterySample
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.robot.chart import battery_chart
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import text_of

WALL = 1_700_000_040.0  # a whole minute
SIZES = [(32, 8), (66, 12), (118, 18)]


def clock(wall: float) -> str:
    minutes = round(wall - WALL) // 60
    return f"{12 + minutes // 60:02}:{minutes % 60:02}:00"


def lines(
    samples: list[BatterySample],
    size: tuple[int, int] = SIZES[1],
    drawing: Drawing = Drawing.BRAILLE,
    now: float = 3600.0,
) -> list[str]:
    chart = battery_chart(samples, (now, WALL + now), size, 20.0, clock, drawing)
    assert all(width_of(line) == size[0] for line in chart) and len(chart) == size[1]
    return [text_of(line) for line in chart]


def falling(begin: float, end: float, gap: bool = False) -> list[BatterySample]:
    """A level a minute, of 80 per cent at 0 s and 20 at 3600 s."""
    return [
        BatterySample(float(at), 80.0 - at / 60, at > begin or not gap)
        for at in range(int(begin), int(end) + 1, 60)
    ]


def columns(shown: list[str]) -> list[int]:
    """The columns with something drawn, right of the axis."""
    plot = shown[:-2]
    axis = next(n for n, sign in enumerate(plot[0]) if sign in "┤+") + 1
    return [x - axis for x in range(axis, len(plot[0])) if any(line[x] != " " for line in plot)]


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("drawing", Drawing)
def test_it_fills_its_size_with_axes_of_levels_and_times(size: tuple[int, int], drawing: Drawing) -> None:
    shown = lines(falling(0, 3600), size, drawing)
    assert shown[0].startswith("100 %") and any(line.startswith(" 20 %") for line in shown)
    assert "12:" in shown[-1] and len(columns(shown)) > 0.9 * (size[0] - 8)
    assert drawing is not Drawing.ASCII or all(line.isascii() for line in shown)


def test_what_was_not_seen_is_not_drawn() -> None:
    seen = falling(0, 900), falling(2700, 3600, gap=True)
    drawn = columns(lines([*seen[0], *seen[1]]))
    gaps = [b - a for a, b in pairwise(drawn) if b - a > 1]
    assert len(gaps) == 1 and gaps[0] > 20


def test_a_curve_that_ended_long_ago_ends_there() -> None:
    drawn = columns(lines(falling(0, 1800)))
    assert max(drawn) < 0.6 * 60


@pytest.mark.parametrize(
    ("since", "first"), [(10, "12:59"), (60, "12:59"), (61, "12:58"), (121, "12:55"), (301, "12:50")]
)
def test_the_axis_of_a_short_time_is_no_longer_than_it_needs(since: int, first: str) -> None:
    shown = lines([BatterySample(3600.0 - since, 50.0, False), BatterySample(3600.0, 50.0, True)])
    assert shown[-1].split()[0] == first
