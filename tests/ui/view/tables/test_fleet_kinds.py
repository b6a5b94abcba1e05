"""Rows of robots of several kinds: a column exists where a robot has something for it."""

import math

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import CargoReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER_TO, PAUSE, Kind
from fleet_tui.ui.view.tables.fleet import CARGO, fleet_table
from tests.support.fleets import R0, T0, battery, commanded, place_order, pose, queue, reduced, text_of, tick
from tests.support.kinds import BARE, FULL, LATE, received


def rows(state: FleetState) -> list[str]:
    return [text_of(row.runs).rstrip() for row in fleet_table(state, R0, 60).rows]


def test_a_fleet_that_reports_little_has_few_columns() -> None:
    assert rows(received(BARE)) == ["● 0 robot_0 floor_0" + 22 * " " + "unknown"]


def test_a_value_that_has_not_come_is_a_dash_and_one_that_never_does_is_nothing() -> None:
    bare, late, full = rows(received(BARE, LATE, FULL))
    assert bare == "● 0 robot_0       floor_0   unknown"
    assert late.split() == ["●", "1", "robot_1", "-", "%", "floor_0", "idle"]
    assert full.split()[3:] == ["-", "%", "floor_0", "no", "queue", "yet"]


def test_columns_stand_below_each_other_whatever_the_kind() -> None:
    state = reduced(received(BARE, FULL), CargoReported("robot_1", T0, True), queue(T0, robot="robot_1"))
    bare, full = rows(reduced(state, battery(T0, robot="robot_1"), tick(T0)))
    assert full.split() == ["●", "1", "robot_1", "80", "%", "floor_0", CARGO, "idle"]
    assert bare.index("floor_0") == full.index("floor_0")


def test_idle_is_said_only_where_something_tells() -> None:
    assert "idle" not in "".join(rows(received(BARE, FULL)))
    assert rows(reduced(received(FULL), queue(T0), tick(T0)))[0].endswith("idle")


def test_a_value_is_called_old_after_the_silence_of_its_kind() -> None:
    later = reduced(reduced(received(LATE), battery(T0), queue(T0)), pose(T0 + 9), tick(T0 + 9))
    assert "battery 9 s old" in rows(later)[0] and "queue" not in rows(later)[0]


def test_a_pause_that_only_holds_a_goal_says_so() -> None:
    holds = Kind(
        "holds", ("pose", "queue"), (ORDER_TO, PAUSE), {"queue": math.inf}, keeps_goals=True, holds=True
    )
    paused = (*commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0), tick(T0))
    state = reduced(received(holds), queue(T0), *paused)
    assert "stopped, no goal to keep" in rows(state)[0] and "paused" not in rows(state)[0]
    kept = reduced(state, *commanded(2, place_order(R0, 1), Stage.WAITING, at=T0), tick(T0))
    assert "stopped, goal kept here" in rows(kept)[0]
    assert "paused (by us)" in rows(reduced(received(FULL), queue(T0), *paused))[0]
