"""Keys are hinted where they do something, and where the selected robot has a use for them."""

import pytest

from fleet_tui.keymap import keymap
from fleet_tui.keys import Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import PAUSE, Kind
from fleet_tui.view.lines.hints import hidden_keys, hints
from tests.support.fleets import (
    R0,
    text_of,
)
from tests.support.kinds import BARE, FULL, KEYS, LATE, heard


@pytest.mark.parametrize("pane", [Pane.MAP, Pane.TABLE])
def test_hints_show_the_keys_as_they_are_set(pane: Pane) -> None:
    chosen, problems = keymap({"order": "O", "menu": "home"})
    left, right = hints(chosen, pane)
    assert problems == []
    assert " O order " in text_of(left) and " ? help " in text_of(right) and " : command " in text_of(right)
    assert (" home menu " in text_of(left)) is (pane is Pane.TABLE)
    assert text_of(left).startswith(" home menu " if pane is Pane.TABLE else " O order ")


def test_hints_of_an_overlay_are_the_keys_that_reach_through_it() -> None:
    chosen, _ = keymap({"help_anywhere": "f2"})
    left, right = hints(chosen, Pane.ANYWHERE)
    assert text_of(left) == " f2 help  f12 pause all " and right == []


@pytest.mark.parametrize("pane", [Pane.MAP, Pane.TABLE, Pane.RECORDING, Pane.ANYWHERE])
def test_a_console_that_can_not_command_offers_no_commands(pane: Pane) -> None:
    chosen, _ = keymap({})
    may = "".join(text_of(part) for part in hints(chosen, pane))
    may_not = "".join(text_of(part) for part in hints(chosen, pane, can_command=False))
    assert " pause all " in may and " help " in may_not
    assert not any(f" {word} " in may_not for word in ("order", "cancel", "clear", "pause", "resume"))


def offered(state: FleetState) -> set[str]:
    left, _ = hints(KEYS, Pane.CONSOLE, hidden=hidden_keys(state, R0))
    return set(text_of(left).split()) & {"order", "cancel", "clear", "pause", "resume", "all"}


def test_keys_are_hinted_where_the_selected_robot_has_a_use_for_them() -> None:
    assert offered(heard(FULL)) == {"order", "cancel", "clear", "pause", "resume", "all"}
    assert offered(heard(BARE)) == {"order"}
    assert offered(heard(LATE)) == {"order", "cancel", "all"}  # all orders


def test_pause_all_is_there_as_soon_as_one_robot_can_be_paused() -> None:
    state = heard(BARE, Kind("p", accepts=(PAUSE,)))
    assert "pause" in hidden_keys(state, R0) and "pause_all" not in hidden_keys(state, R0)
    assert {"pause_all", "pause_all_anywhere"} <= hidden_keys(heard(BARE, BARE), R0)
