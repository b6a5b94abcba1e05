"""Positions in nested blocks."""

from fleet_tui.model.routines.lane import Part, Position
from fleet_tui.rules.routines.positions import after, again, block_at, leaf_at
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
