"""Rows of the table of keys: where they work, and which section of help lists them."""

import pytest

from fleet_tui.keys import BY_ID, KEYS
from fleet_tui.keys.key import Pane, key_name


def test_keys_that_work_everywhere_are_those_without_a_pane_of_their_own() -> None:
    assert {pane for pane in Pane if pane.is_everywhere} == {Pane.CONSOLE, Pane.ANYWHERE, Pane.RECORDING}


def test_a_key_of_the_map_or_the_tables_is_in_its_section_wherever_it_works() -> None:
    of_map = [key for key in KEYS if key.of_map]
    of_rows = [key for key in KEYS if key.of_rows]
    assert of_map and all(key.section is Pane.MAP for key in of_map)
    assert of_rows and all(key.section is Pane.ROWS for key in of_rows)
    assert all(key.section is key.pane for key in KEYS if not (key.of_map or key.of_rows))


def test_every_row_is_found_by_its_id() -> None:
    assert len(BY_ID) == len(KEYS)


def test_keys_that_command_are_hidden_from_who_may_not_and_need_a_robot_that_can() -> None:
    commanding = {key.id for key in KEYS if key.commands}
    assert commanding == {
        *("order", "cancel", "clear", "charge", "pose", "goal", "drive"),
        *("pause", "resume", "pause_all", "pause_all_anywhere", "resume_all"),
    }
    assert all(BY_ID[id_].needs for id_ in commanding)


@pytest.mark.parametrize(
    ("key", "name"),
    [
        ("o", "o"),
        ("P", "P"),
        ("+", "+"),
        ("ctrl+p", "Ctrl-P"),
        ("alt+x", "Alt-x"),
        ("shift+tab", "Shift-Tab"),
        ("escape", "Esc"),
        ("f12", "F12"),
        ("pagedown", "PgDn"),
    ],
)
def test_keys_are_named_as_people_write_them(key: str, name: str) -> None:
    assert key_name(key) == name
