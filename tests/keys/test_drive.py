"""The keys of driving by hand."""

from fleet_tui.keymap import keymap
from fleet_tui.keys import BY_ID, KEYS, Pane, overruled
from fleet_tui.keys.drive import PASSES


def test_no_other_key_has_a_meaning_in_a_drive_but_those_that_end_it() -> None:
    chosen, problems = keymap({})
    assert problems == []
    blocked = overruled(chosen, Pane.DRIVE)
    assert {"quit", "order", "why", "acknowledge", "edges", "zoom_in", "back", "robot_1"} <= blocked
    assert not blocked & PASSES and BY_ID.keys() >= PASSES
    assert not any(BY_ID[id_].pane is Pane.DRIVE for id_ in blocked)


def test_none_works_in_a_recording_and_beginning_commands_the_robot() -> None:
    assert all(key.only_live for key in KEYS if key.pane is Pane.DRIVE or key.id == "drive")
    assert BY_ID["drive"].commands and BY_ID["drive"].needs == "drive"
