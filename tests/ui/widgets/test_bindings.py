"""Keys of the table as Textual's bindings: named as it names them, in their pane, and never without a key."""

import pytest

from fleet_tui.keys import BY_ID, KEYS, Pane
from fleet_tui.ui.widgets.bindings import action_of, bindings, textual_key, textual_keymap


@pytest.mark.parametrize(
    ("key", "name"),
    [
        ("}", "right_curly_bracket"),
        ("ctrl+p", "ctrl+p"),
        ("f12", "f12"),
        ("+", "plus"),
        ("a", "a"),
        ("?", "question_mark"),
    ],
)
def test_a_key_has_textuals_name(key: str, name: str) -> None:
    assert textual_key(key) == name


@pytest.mark.parametrize("pane", Pane)
def test_a_pane_has_the_bindings_of_its_keys(pane: Pane) -> None:
    found = {binding.id: binding for binding in bindings(pane) if not isinstance(binding, tuple)}
    assert list(found) == [key.id for key in KEYS if key.pane is pane]
    assert all(binding.key for binding in found.values()), "an empty one would match any key"
    for id_, binding in found.items():
        assert binding.priority is (pane is Pane.ANYWHERE or BY_ID[str(id_)].in_dialogs)


def test_tables_run_their_own_keys_and_the_screen_the_others() -> None:
    assert action_of(BY_ID["pause"]) == "screen.key('pause')"
    table = next(key for key in KEYS if key.pane is Pane.ROWS)
    assert action_of(table) == f"key({table.id!r})"


def test_changed_keys_are_textuals_keymap() -> None:
    assert textual_keymap({"pause": ("P", "}"), "record": ()}) == {
        "pause": "P,right_curly_bracket",
        "record": "no_key_for_record",
    }
