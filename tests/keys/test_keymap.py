"""One key does one thing, and the operator's page and the table of keys say the same."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.keys import KEYS, Key, Pane
from fleet_tui.keys.key import key_name
from fleet_tui.keys.keymap import keymap

IDS = [key.id for key in KEYS]
# The operator's page, by what each key does. What is not there yet is in no table.
PROMISED = {
    "help": ["?"],
    "help_anywhere": ["f1"],
    "palette": [":", "ctrl+p"],
    "quit": ["q"],
    "back": ["escape"],
    "next_pane": ["tab"],
    "previous_pane": ["shift+tab"],
    "next_robot": ["]"],
    "previous_robot": ["["],
    **{f"robot_{n}": [str(n)] for n in range(1, 10)},
    "next_robot_plain": ["."],
    "previous_robot_plain": [","],
    "next_floor": ["}"],
    "previous_floor": ["{"],
    "next_floor_plain": [">"],
    "previous_floor_plain": ["<"],
    "order": ["o"],
    "simple": ["s"],
    "cancel": ["x"],
    "menu": ["enter"],
    "pick": ["enter"],
    "map_cursor": ["g"],
    "clear": ["X"],
    "pause": ["p"],
    "resume": ["r"],
    "pause_all": ["P"],
    "resume_all": ["R"],
    "pause_all_anywhere": ["f12"],
    "all_orders": ["*"],
    "why": ["w"],
    "diagnostics": ["d"],
    "history": ["H"],
    "bundle": ["b"],
    "programs": ["J"],
    "acknowledge": ["a"],
    "acknowledge_all": ["A"],
    **{
        f"pan_{way}": [way, letter]
        for way, letter in zip(("left", "down", "up", "right"), "hjkl", strict=True)
    },
    "row_up": ["up", "k"],
    "row_down": ["down", "j"],
    "zoom_in": ["+"],
    "zoom_out": ["-"],
    "fit": ["0"],
    "zoom_about": ["z"],
    "follow": ["f"],
    "centre": ["c"],
    "next_vertex": ["n"],
    "previous_vertex": ["N"],
    "edges": ["e"],
    "labels": ["v"],
    "drawing": ["m"],
}


# The palette reaches them; the config can give them a key.
WITHOUT_A_KEY = {"alarm_menu", "arm", "desk", "record", "save"}


def test_the_defaults_have_no_clash() -> None:
    chosen, problems = keymap({})
    assert problems == []
    assert list(chosen) == IDS and len(set(IDS)) == len(IDS)
    assert {id_ for id_, keys in chosen.items() if not keys} <= WITHOUT_A_KEY


@pytest.mark.parametrize("key", [key for key in KEYS if key.id in PROMISED], ids=lambda key: key.id)
def test_every_default_is_the_promised_key(key: Key) -> None:
    assert set(PROMISED[key.id]) <= set(key.keys)


def test_no_promised_key_of_the_console_does_something_else() -> None:
    promised = {name for keys in PROMISED.values() for name in keys}
    others = [
        key
        for key in KEYS
        if key.id not in PROMISED
        and not key.pane.is_mode
        and key.pane not in (Pane.ROWS, Pane.DIAGNOSTICS, Pane.HISTORY, Pane.RECORDING)
    ]
    assert [key.id for key in others if promised & set(key.keys)] == []


def test_ctrl_c_commands_nothing() -> None:
    assert [key.id for key in KEYS if "ctrl+c" in key.keys] == ["say_quit"]


def test_what_works_while_typing_types_nothing() -> None:
    assert {key.id: key.keys for key in KEYS if key.pane is Pane.ANYWHERE} == {
        "help_anywhere": ("f1",),
        "repaint": ("ctrl+l",),
        "pause_all_anywhere": ("f12",),
        "say_quit": ("ctrl+c", "ctrl+q"),
    }


def test_a_key_is_changed_and_only_that() -> None:
    chosen, problems = keymap({"order": "O", "palette": "ctrl+k, f5", "help": ","})
    assert problems == []
    assert (chosen["order"], chosen["palette"], chosen["help"]) == (("O",), ("ctrl+k", "f5"), (",",))
    before, _ = keymap({})
    changed = {"order", "palette", "help", "step_back", "previous_robot_plain"}
    assert {id_: keys for id_, keys in chosen.items() if id_ not in changed} == {
        id_: keys for id_, keys in before.items() if id_ not in changed
    }


def test_a_recording_leaves_a_key_to_what_the_config_gives_it_to() -> None:
    chosen, problems = keymap({"pause": "space", "order": "@,O"})
    assert problems == []
    assert (chosen["play"], chosen["go_to_time"]) == ((), ("ctrl+g",))
    assert chosen["skip_on"] == (">",)
    assert keymap({"pause": "space", "play": "space"})[1] != []


def test_a_second_key_gives_way_to_what_the_config_assigns() -> None:
    chosen, problems = keymap({"order": "."})
    assert (problems, chosen["next_robot_plain"], chosen["next_robot"]) == ([], (), ("]",))
    assert keymap({"order": ".", "next_robot_plain": "."})[1] != []


def test_two_ids_may_change_places() -> None:
    assert keymap({"pause": "r", "resume": "p"})[1] == []


@pytest.mark.parametrize(
    ("changes", "taken_by"),
    [
        ({"order": "p"}, "order"),
        ({"quit": "left"}, "quit"),  # a pane's key and one of the whole console meet
        ({"pan_left": "q"}, "quit"),
        ({"pan_left": "right"}, "pan_left"),
        ({"pan_left": "f12"}, "pause_all_anywhere"),
        ({"quit": "f1"}, "help_anywhere"),
        ({"quit": "q,q"}, "quit"),
    ],
)
def test_a_clash_is_refused_and_names_both(changes: dict[str, str], taken_by: str) -> None:
    _, problems = keymap(changes)
    assert problems and all("is already used by" in line for line in problems)
    assert any(taken_by in line for line in problems)


def test_panes_may_share_a_key() -> None:
    assert keymap({"pan_left": "a1"})[1] != []
    assert keymap({"pan_left": "home", "row_up": "home"})[1] == []


@pytest.mark.parametrize(
    ("key", "says"),
    [
        ("ctrl+c", "Ctrl-C is reserved"),
        ("ctrl+C", "ctrl+c"),
        ("ctrl+i", "tab"),
        ("ctrl+m", "enter"),
        ("ctrl+[", "escape"),
        ("entr", "did you mean enter?"),
        ("f25", "unknown key"),
        ("", "unknown key"),
        ("ctrl+", "unknown key"),
        ("shift+a", "use the shifted character itself"),
        ("super+a", "unknown modifier super"),
        ("\x1b", "unknown key"),
        ("ab", "unknown key"),
        ("x,", "unknown key"),
    ],
)
def test_impossible_keys_are_refused_with_the_reason(key: str, says: str) -> None:
    _, problems = keymap({"order": key})
    assert any(line.startswith("keys.order: ") and says in line for line in problems)


@pytest.mark.parametrize("key", ["space", "a", "é", "backspace", "enter", "left", "shift+tab"])
def test_a_key_that_a_text_field_needs_cannot_work_while_typing(key: str) -> None:
    """Else every space typed into a form would pause the fleet."""
    _, problems = keymap({"pause_all_anywhere": key})
    assert any("use a function key or a ctrl key" in line for line in problems)
    assert keymap({"pause_all_anywhere": "shift+f5", "help_anywhere": "ctrl+g"})[1] == []


def test_an_unknown_id_is_answered_with_the_nearest() -> None:
    assert keymap({"ordr": "o"})[1] == ["keys.ordr: unknown key id, did you mean order?"]
    assert keymap({"zzzzzz": "o"})[1] == ["keys.zzzzzz: unknown key id"]


@given(st.dictionaries(st.sampled_from(IDS) | st.text(max_size=6), st.text(max_size=6), max_size=6))
def test_whatever_is_asked_either_works_or_is_refused(changes: dict[str, str]) -> None:
    chosen, problems = keymap(changes)
    assert list(chosen) == IDS
    if problems:
        return
    panes = {key.id: key.pane for key in KEYS}
    everywhere = [
        key for id_, keys in chosen.items() if panes[id_] in (Pane.CONSOLE, Pane.ANYWHERE) for key in keys
    ]
    assert len(everywhere) == len(set(everywhere))
    for pane in (Pane.MAP, Pane.ROWS):
        own = [key for id_, keys in chosen.items() if panes[id_] == pane for key in keys]
        assert len(own) == len(set(own)) and not set(own) & set(everywhere)


def test_the_reference_lists_every_id_with_its_keys() -> None:
    lines = (Path(__file__).parents[2] / "docs" / "keys.md").read_text().splitlines()
    listed = [line for line in lines if line.startswith("| `") and line.endswith(" |")]
    for key in KEYS:
        names = " ".join(f"`{key_name(one)}`" for one in key.keys) or "(palette)"
        assert f"| `{key.id}` | {names} | {key.text} |" in listed
