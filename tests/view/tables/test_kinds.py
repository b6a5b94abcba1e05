"""Rows, hints and JSON of robots of several kinds: a column exists where a robot has something for it."""

import math

import pytest

from fleet_tui.cli.status.report import report
from fleet_tui.keymap import keymap
from fleet_tui.keys import Pane
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import CargoReported, ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import CANCEL, ORDER, ORDER_TO, PAUSE, Kind
from fleet_tui.screens.help import notes
from fleet_tui.view.lines.commands import command_text
from fleet_tui.view.lines.hints import hidden_keys, hints
from fleet_tui.view.lines.why import why_lines
from fleet_tui.view.tables.fleet import CARGO, fleet_table
from fleet_tui.view.tables.queue import CANCEL as CANCEL_BUTTON
from fleet_tui.view.tables.queue import CLEAR as CLEAR_BUTTON
from fleet_tui.view.tables.queue import queue_table
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    text_of,
    tick,
    told,
)

FULL = fleet().robots[R0].kind
BARE = Kind("bare", ("pose",), (ORDER_TO,))
LATE = Kind("late", ("pose", "battery", "queue"), (ORDER, CANCEL), {"queue": math.inf})
KEYS, _ = keymap({})


def heard(*kinds: Kind) -> FleetState:
    state = of_kinds(fleet(len(kinds)), *kinds)
    poses = [pose(T0, robot=name) for name in state.robots]
    return told(state, link_up(T0), *poses, graph(1, 2), labels({1: "Base"}), tick(T0))


def rows(state: FleetState) -> list[str]:
    return [text_of(row.runs).rstrip() for row in fleet_table(state, R0, 100).rows]


def test_a_fleet_that_reports_little_has_few_columns() -> None:
    assert rows(heard(BARE)) == ["● 1 robot_0 floor_0"]


def test_a_value_that_has_not_come_is_a_dash_and_one_that_never_does_is_nothing() -> None:
    bare, late, full = rows(heard(BARE, LATE, FULL))
    assert bare == "● 1 robot_0       floor_0"
    assert late == "● 2 robot_1   - % floor_0   -"
    assert full == "● 3 robot_2   - % floor_0   queue missing"


def test_columns_stand_below_each_other_whatever_the_kind() -> None:
    state = told(heard(BARE, FULL), CargoReported("robot_1", T0, True), queue(T0, robot="robot_1"))
    bare, full = rows(told(state, battery(T0, robot="robot_1"), tick(T0)))
    assert full == f"● 2 robot_1  80 % floor_0 {CARGO} idle"
    assert bare.index("floor_0") == full.index("floor_0")


def test_idle_is_said_only_where_something_tells() -> None:
    assert "idle" not in "".join(rows(heard(BARE, LATE)))
    assert rows(told(heard(LATE), queue(T0), tick(T0)))[0].endswith("idle")


def test_a_value_is_called_old_after_the_silence_of_its_kind() -> None:
    later = told(told(heard(LATE), battery(T0), queue(T0)), pose(T0 + 9), tick(T0 + 9))
    assert "battery 9 s old" in rows(later)[0] and "queue" not in rows(later)[0]


def test_the_queue_pane_of_a_kind_without_a_queue() -> None:
    table = queue_table(heard(BARE), R0, False, 80)
    assert (text_of(table.title), table.empty) == ("Queue robot_0", "this kind has no queue")
    assert queue_table(heard(LATE), R0, False, 80).empty == "no orders reported yet"
    assert queue_table(heard(FULL), R0, False, 80).empty == "no queue received yet"


@pytest.mark.parametrize(("kind", "cancels", "clears"), [(FULL, True, True), (LATE, True, False)])
def test_only_what_is_accepted_has_a_button(kind: Kind, cancels: bool, clears: bool) -> None:
    table = queue_table(told(heard(kind), queue(T0, (1, 1, 2, "Q"))), R0, False, 80)
    assert (CLEAR_BUTTON in text_of(table.title)) is clears
    assert (CANCEL_BUTTON in text_of(table.rows[0].runs)) is cancels


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


def test_help_tells_of_what_can_be_typed() -> None:
    assert "pause all" in notes(FULL) and "cargo on board to B" in notes(FULL)
    for word in ("pause", "cancel", "clear", "cargo"):
        assert word not in notes(BARE).partition("Confirmations: ")[0]
    assert "directly to B" in notes(BARE)


def test_an_order_to_one_place_is_said_as_the_kind_takes_it() -> None:
    assert command_text(heard(BARE), place_order(R0, 1)) == "robot_0 go to Base"
    assert command_text(heard(FULL), place_order(R0, 1)) == "robot_0 bring cargo -> Base"
    assert place_order(R0, 1).what(BARE) == "order"


def test_why_offers_no_key_that_the_kind_does_not_accept() -> None:
    orders = queue(T0 + 9)
    for kind, is_offered in ((FULL, True), (Kind("x", FULL.reports), False)):
        state = told(heard(kind), orders, pose(T0 + 9), tick(T0 + 9))
        lines = why_lines(state, state.robots[R0], KEYS)
        assert any("no orders" in line for line in lines)
        assert any("order form" in line for line in lines) is is_offered


def test_json_has_no_key_for_what_a_kind_never_tells_and_null_for_what_has_not_come() -> None:
    state = told(heard(BARE, LATE, FULL), ObstacleReported("robot_2", T0, 0.0))
    bare, late, full = report(state)["robots"]
    assert {"battery_percent", "cargo", "obstacle_s", "paused", "orders"}.isdisjoint(bare)
    assert (late["battery_percent"], late["orders"]) == (None, None) and "cargo" not in late
    assert (full["cargo"], full["obstacle_s"], full["paused"]) == (None, 0.0, None)
    assert (bare["never_came"], late["never_came"]) == ([], ["battery"])
    assert [one["kind"] for one in (bare, late)] == ["bare", "late"]


def test_a_pause_that_only_holds_a_goal_says_so() -> None:
    holds = Kind(
        "holds", ("pose", "queue"), (ORDER_TO, PAUSE), {"queue": math.inf}, keeps_goals=True, holds=True
    )
    paused = (*commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0), tick(T0))
    state = told(heard(holds), queue(T0), *paused)
    assert "stopped, no goal to keep" in rows(state)[0] and "paused" not in rows(state)[0]
    kept = told(state, *commanded(2, place_order(R0, 1), Stage.WAITING, at=T0), tick(T0))
    assert "stopped, goal kept here" in rows(kept)[0]
    assert "paused (by us)" in rows(told(heard(FULL), queue(T0), *paused))[0]
