"""Marks of a time axis."""

import pytest

from fleet_tui.features.history.report.axis import DAY, HOUR, MOST, LocalTime, axis, marks
from fleet_tui.records.history.division import Division


@pytest.mark.parametrize("span", [600.0, 8 * HOUR, 30 * HOUR, 30 * DAY, 400 * DAY])
@pytest.mark.parametrize("offset", [0.0, 5.5 * HOUR, -3 * HOUR])
def test_marks_are_round_local_times_within(span: float, offset: float) -> None:
    time = Division(1_000_000.0, 1_000_000.0 + span, 240)
    found = marks(time, offset)
    assert 1 <= len(found) <= MOST + 1 and all(time.since <= at <= time.until for at in found)
    assert all((at + offset) % 60 == 0 for at in found)
    if span >= 30 * DAY:
        assert all((at + offset) % DAY == 0 for at in found)


def test_days_are_told_as_dates() -> None:
    said: list[bool] = []

    def clock(_at: float, is_long: bool) -> str:
        said.append(is_long)
        return "x"

    for span in (8 * HOUR, 7 * DAY):
        axis(Division(0.0, span, 10), LocalTime(0.0, clock, clock), 0.0, 100.0, 50.0)
    assert said[0] is False and said[-1] is True
