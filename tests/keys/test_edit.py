"""The keys of the graph editor."""

from fleet_tui.keymap import keymap
from fleet_tui.keys import KEYS, Pane, overruled


def test_they_come_before_keys_that_come_before_all_others_but_before_no_pause_of_all() -> None:
    chosen, _ = keymap({})
    assert {"diagnostics", "audit"} <= overruled(chosen, Pane.EDIT)
    assert not overruled(chosen, Pane.EDIT) & {"pause_all", "pause_all_anywhere", "help", "order", "robot_1"}


def test_a_key_of_the_editor_may_be_one_of_the_console_but_not_of_another_step() -> None:
    assert keymap({"edit_add": "o"})[1] == []
    (problem,) = keymap({"edit_add": "x"})[1]
    assert "already used" in problem
    assert keymap({"edit_add": "f12"})[1] != []


def test_a_changed_key_of_the_editor_overrules_another_one() -> None:
    assert "order" in overruled(keymap({"edit_add": "o"})[0], Pane.EDIT)


def test_none_works_in_a_recording() -> None:
    assert all(key.only_live for key in KEYS if key.pane is Pane.EDIT or key.id == "edit")
