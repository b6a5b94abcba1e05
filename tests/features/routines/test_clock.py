"""The local clock: the next time it shows."""

import re
from datetime import datetime

from fleet_tui.features.routines.blocks import DayTime
from fleet_tui.features.routines.clock import clock_text, next_time


def at(*parts: int) -> float:
    return datetime(*parts).timestamp()  # type: ignore[arg-type]  # year, month, day, hour, minute


def test_it_is_today_or_tomorrow() -> None:
    assert next_time(DayTime(390), at(2024, 5, 6, 6, 0)) == at(2024, 5, 6, 6, 30)
    assert next_time(DayTime(390), at(2024, 5, 6, 6, 30)) == at(2024, 5, 6, 6, 30)
    assert next_time(DayTime(390), at(2024, 5, 6, 6, 31)) == at(2024, 5, 7, 6, 30)


def test_it_is_shown_as_a_time() -> None:
    assert re.fullmatch(r"06:30:00", clock_text(at(2024, 5, 6, 6, 30)))
