"""Positions in nested blocks."""

import pytest

from fleet_tui.features.routines.lane import Lane, LanePhase, Part, Position
from fleet_tui.features.routines.rules.positions import after, again, block_at, fits, leaf_at
from tests.support.routines import plan_of

PLAN = plan_of("repeat 2", "if idle", "go A", "else", "go B", "end", "end", "on failure", "go C", "end")


def test_a_path_leads_into_every_part() -> None:
    outer = (Position(), Position())
    assert leaf_at(PLAN, (*outer, Position(Part.BODY))).text == "go A"
    assert leaf_at(PLAN, (*outer, Position(Part.ELSE))).text == "go B"
    assert leaf_at(PLAN, (Position(Part.FAILURE),)).text == "go C"


def test_after_the_last_block_there_is_none() -> None:
    path = (Position(), Position(index=1, round=1))
    assert block_at(PLAN, path) is None
    assert again(path) == (Position(), Position(round=2)) and after(path)[-1].index == 2


@pytest.mark.parametrize(
    ("lane", "can_go_on"),
    [
        (Lane("r"), True),
        (Lane("r", (Position(index=1),)), True),
        (Lane("r", (Position(index=2),)), True),
        (Lane("r", (Position(Part.FAILURE),), LanePhase.ORDERED), True),
        (Lane("r", (Position(), Position(index=-1))), False),
        (Lane("r", (Position(index=7), Position())), False),
        (Lane("r", (Position(), Position(Part.ELSE))), False),
        (Lane("r", phase=LanePhase.ORDERED), False),
    ],
)
def test_a_kept_lane_fits_its_plan_or_not(lane: Lane, can_go_on: bool) -> None:
    assert fits(PLAN, lane) is can_go_on
