"""The keys of driving by hand."""

from fleet_tui.keys import BY_ID, KEYS, Pane
from fleet_tui.keys.drive import PASSES
from fleet_tui.keys.keymap import keymap


def test_the_keys_that_end_a_drive_exist() -> None:
    assert keymap({})[1] == []
    assert BY_ID.keys() >= PASSES
    assert not any(BY_ID[id_].pane is Pane.DRIVE for id_ in PASSES)


def test_none_works_in_a_recording_and_beginning_commands_the_robot() -> None:
    assert all(key.only_live for key in KEYS if key.pane is Pane.DRIVE or key.id == "drive")
    assert BY_ID["drive"].commands and BY_ID["drive"].needs == "drive"
