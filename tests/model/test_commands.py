"""The table of a command's life: every stage has its place in it."""

from fleet_tui.model.commands import NEXT, Stage


def test_every_stage_has_its_place_in_the_table() -> None:
    assert set(NEXT) == set(Stage)
    reached, new = {Stage.CHECKED}, {Stage.CHECKED}
    while new:
        new = {later for stage in new for later in NEXT[stage]} - reached
        reached |= new
    assert reached == set(Stage)
