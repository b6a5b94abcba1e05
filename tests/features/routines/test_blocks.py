"""Blocks and schedules as they are typed."""

import pytest

from fleet_tui.features.routines.blocks import DayTime, Schedule


@pytest.mark.parametrize(
    ("days", "text"),
    [(tuple(range(7)), "day 00:05"), (tuple(range(5)), "weekday 00:05"), ((6,), "sunday 00:05")],
)
def test_a_schedule_is_told_as_it_is_typed(days: tuple[int, ...], text: str) -> None:
    assert Schedule(days, DayTime(5)).text == text
