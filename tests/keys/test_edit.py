"""The keys of the graph editor."""

from fleet_tui.keys import KEYS, Pane
from fleet_tui.keys.keymap import keymap


def test_a_key_of_the_editor_may_be_one_of_the_console_but_not_of_another_step() -> None:
    assert keymap({"edit_add": "o"})[1] == []
    (problem,) = keymap({"edit_add": "x"})[1]
    assert "already used" in problem
    assert keymap({"edit_add": "f12"})[1] != []
    assert keymap({"edit_add": "P"})[1] != []


def test_none_works_in_a_recording() -> None:
    assert all(key.only_live for key in KEYS if key.pane is Pane.EDIT or key.id == "edit")
