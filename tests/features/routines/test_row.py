"""A routine as it is listed."""

import pytest

from fleet_tui.features.routines.lane import Lane, LanePhase
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.text.language import Message

DONE, OPEN = Lane("a", phase=LanePhase.DONE), Lane("b")


@pytest.mark.parametrize(
    ("row", "is_left"),
    [
        (RoutineRow("day"), False),
        (RoutineRow("day", lanes=(DONE,)), False),
        (RoutineRow("day", lanes=(DONE, OPEN)), True),
        (RoutineRow("day", lanes=(OPEN,), owner=Message("ana")), False),
    ],
)
def test_one_that_nobody_leads_any_more_was_left(row: RoutineRow, is_left: bool) -> None:
    assert row.is_left is is_left
