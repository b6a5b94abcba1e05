"""Keys are hinted where they do something, and where the selected robot has a use for them."""

from itertools import pairwise

import pytest

from fleet_tui.keys import Pane
from fleet_tui.keys.keymap import keymap
from fleet_tui.model.events import PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import PAUSE, Kind
from fleet_tui.model.problem import Right
from fleet_tui.ui.view.lines.hints import footer, hidden_keys, hints, idle_hints, unoffered_keys
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import R0, T0, battery, fleet, link_lost, link_up, reduced, text_of, tick
from tests.support.kinds import BARE, FULL, KEYS, LATE, received

Keys = dict[str, tuple[str, ...]]


def line(chosen: Keys, pane: Pane, width: int = 200, can_command: bool = True) -> str:
    return text_of(footer(*hints(chosen, pane, can_command), chosen, width)[0])


@pytest.mark.parametrize("pane", [Pane.MAP, Pane.ROWS])
def test_hints_show_the_keys_as_they_are_set(pane: Pane) -> None:
    chosen, problems = keymap({"order": "O", "menu": "home"})
    shown = line(chosen, pane)
    assert problems == []
    assert " O order " in shown and shown.endswith(" ? help  : command  q quit ")
    assert (" Home menu " in shown) is (pane is Pane.ROWS)
    assert shown.startswith(" O order ")


def test_hints_of_an_overlay_are_the_keys_that_reach_through_it() -> None:
    chosen, _ = keymap({"help_anywhere": "f2"})
    assert line(chosen, Pane.ANYWHERE).rstrip() == " Esc close  F2 help  F12 pause all"


@pytest.mark.parametrize("pane", [Pane.MAP, Pane.ROWS, Pane.RECORDING, Pane.ANYWHERE])
def test_a_console_that_can_not_command_offers_no_commands(pane: Pane) -> None:
    may, may_not = (line(KEYS, pane, can_command=can) for can in (True, False))
    assert " pause all " in may and " help " in may_not
    assert not any(f" {word} " in may_not for word in ("order", "cancel", "clear", "pause", "resume"))


def test_the_most_important_hints_are_whole_at_80_columns() -> None:
    calm = hints(KEYS, Pane.MAP, hidden=idle_hints(fleet()))
    shown = text_of(footer(*calm, KEYS, 80)[0])
    assert " alarm " not in shown
    places = [shown.index(f" {word} ") for word in ("order", "pause", "pause all", "why", "cancel")]
    assert places == sorted(places) and " simple " not in shown
    trouble = reduced(fleet(), link_up(T0), battery(T0, 5.0), tick(T0))
    shown = text_of(footer(*hints(KEYS, Pane.MAP, hidden=idle_hints(trouble)), KEYS, 80)[0])
    assert " ! look " in shown and " w why " in shown


def test_a_focused_table_hints_its_filter_and_marks_after_what_everyone_needs() -> None:
    calm = hints(KEYS, Pane.ROWS, hidden=idle_hints(fleet()), focused="fleet")
    shown = text_of(footer(*calm, KEYS, 80)[0])
    places = [shown.index(f" {word} ") for word in ("order", "pause all", "/ filter", "Space mark")]
    assert places == sorted(places)


def test_the_footer_names_whose_alarm_is_acknowledged() -> None:
    trouble = reduced(fleet(), link_up(T0), battery(T0, 5.0), tick(T0))

    def shown(state: FleetState, alarmed: str = "", width: int = 120) -> str:
        return text_of(
            footer(*hints(KEYS, Pane.MAP, hidden=idle_hints(state), alarmed=alarmed), KEYS, width)[0]
        )

    assert " a ack  " in shown(trouble) and " a ack robot_7␛  " in shown(trouble, "robot_7\x1b")
    assert " a ack robot_7 " in shown(trouble, "robot_7", 80)
    assert " a ack robot_with_a_long_name " in shown(trouble, "robot_with_a_long_name", 80)
    assert " a ack" not in shown(fleet())


def test_an_alarm_is_hinted_before_the_end_of_a_pause() -> None:
    paused = PausedReported(R0, T0, True)
    trouble = reduced(fleet(), link_up(T0), paused, battery(T0, 5.0), tick(T0))
    for width, kept in ((80, ("acknowledge",)), (120, ("acknowledge", "resume_all"))):
        left, right = hints(KEYS, Pane.MAP, hidden=idle_hints(trouble, R0))
        shown = [button.name for button in footer(left, right, KEYS, width)[1]]
        assert tuple(name for name in shown if name in ("acknowledge", "resume_all")) == kept


def test_without_a_link_no_command_is_offered_as_if_it_would_be_sent() -> None:
    def shown(state: FleetState) -> str:
        return text_of(footer(*hints(KEYS, Pane.MAP, hidden=idle_hints(state, R0)), KEYS, 200)[0])

    lost = shown(reduced(fleet(), link_up(T0), battery(T0), link_lost(T0 + 1)))
    back = shown(reduced(fleet(), link_up(T0), battery(T0), link_lost(T0 + 1), link_up(T0 + 2)))
    for word in (" o order ", " p pause ", " P pause all ", " x cancel "):
        assert word not in lost and word in back
    assert lost.startswith(" w why ")


@pytest.mark.parametrize("pane", list(Pane))
def test_hints_are_never_cut(pane: Pane) -> None:
    offered = hints(KEYS, pane)
    labels = {key.id: f" {key.hint} " for key in (*offered[0], *offered[1])}
    for width in range(1, 200):
        runs, buttons = footer(*offered, KEYS, width)
        assert width_of(runs) == width
        text = text_of(runs)
        for button in buttons:
            assert text[button.start : button.end].endswith(labels[button.name])
        assert not "".join(text[one.end : other.start] for one, other in pairwise(buttons)).strip()


def offered(state: FleetState) -> set[str]:
    left, _ = hints(KEYS, Pane.CONSOLE, hidden=hidden_keys(state, R0))
    return set(" ".join(key.hint for key in left).split()) & {
        "order",
        "cancel",
        "clear",
        "pause",
        "resume",
        "all",
    }


def test_keys_are_hinted_where_the_selected_robot_has_a_use_for_them() -> None:
    assert offered(received(FULL)) == {"order", "cancel", "clear", "pause", "resume", "all"}
    assert offered(received(BARE)) == {"order"}
    assert offered(received(LATE)) == {"order", "cancel", "all"}  # all orders


def test_pause_all_is_there_as_soon_as_one_robot_can_be_paused() -> None:
    state = received(BARE, Kind("p", accepts=(PAUSE,)))
    assert "pause" in hidden_keys(state, R0) and "pause_all" not in hidden_keys(state, R0)
    assert {"pause_all", "pause_all_anywhere"} <= hidden_keys(received(BARE, BARE), R0)


def test_in_a_drive_no_key_is_hinted_that_would_only_stop_the_robot() -> None:
    chosen, _ = keymap({})
    shown = line(chosen, Pane.DRIVE)
    assert " w ahead " in shown and " Esc leave " in shown and " P pause all " in shown
    assert "order" not in shown and "pause all" in shown and "why" not in shown


def test_keys_without_the_right_are_not_offered() -> None:
    def lacks(right: Right) -> set[str]:
        return unoffered_keys(lambda _key: True, right)

    assert lacks(Right.SETUP) == set()
    assert lacks(Right.DISPATCH) == {"pose", "drive", "edit"}
    assert {"order", "pause", "pause_all", "cancel", "goal", "arm", "simple", "pose"} <= lacks(Right.VIEW)
    assert lacks(Right.VIEW).isdisjoint({"why", "history", "acknowledge", "camera", "programs", "routines"})


def test_a_focused_map_offers_to_be_enlarged_also_at_80_columns() -> None:
    def shown(state: FleetState, focused: str) -> str:
        offered = hints(KEYS, Pane.MAP, hidden=idle_hints(state), focused=focused)
        return text_of(footer(*offered, KEYS, 80)[0])

    assert " = enlarge " in shown(fleet(), "map") and " w why " in shown(fleet(), "map")
    assert " = enlarge " not in shown(fleet(), "events")
    trouble = reduced(fleet(), link_up(T0), battery(T0, 5.0), tick(T0))
    assert " ! look " in shown(trouble, "map") and " w why " in shown(trouble, "map")
