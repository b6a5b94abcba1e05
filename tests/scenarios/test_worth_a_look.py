"""A robot worth a look without an alarm: its row, the alarms pane, the top line, the footer and ! agree."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import Event, MessageRejected, ObstacleReported, PausedReported
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.order import Order
from fleet_tui.model.order_life import GoneOrder
from fleet_tui.situation.alarms.trouble import next_in_trouble
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.lines.hints import idle_hints
from fleet_tui.ui.view.lines.status import status_line
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import alarm_table
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_up,
    pose,
    queue,
    reduced,
    text_of,
    tick,
)

CALM = "robot_1"


def fresh(*facts: Event, at: float = T0 + 10.0) -> FleetState:
    """Two robots that have just reported, and what else one of them did."""
    both = [fact for name in (R0, CALM) for fact in (pose(at, robot=name), battery(at, robot=name))]
    queues = [queue(at, robot=name) for name in (R0, CALM)]
    return reduced(fleet(2), link_up(T0), *both, *queues, *facts, tick(at + 0.1))


def lost() -> FleetState:
    state = fresh()
    gone = GoneOrder(Order("7", (), None, "", 1), state.now - 2.0, Stage.LOST, EMPTY)
    return with_robot(state, replace(state.robots[R0], gone=(gone,)))


def standing() -> FleetState:
    order = queue(T0 + 41.0, (1, 1, 2, "W"), current=1)
    return reduced(fresh(order), *fresh_reports(T0 + 41.0), order, tick(T0 + 41.0))


def fresh_reports(at: float) -> list[Event]:
    return [pose(at), battery(at), pose(at, robot=CALM), battery(at, robot=CALM), queue(at, robot=CALM)]


ODD = {
    "obstacle": fresh(ObstacleReported(R0, T0 + 10, 11.0)),
    "paused (elsewhere)": fresh(PausedReported(R0, T0 + 10, True)),
    "waiting 31 s": standing(),
    "order lost": lost(),
    "pose jumps": fresh(*(pose(T0 + 6 + n, 20.0 * (n % 2)) for n in range(5))),
    "bad data": fresh(tick(T0 + 10), MessageRejected(R0, Message("pose: not a number"))),
    "battery 11 s old": reduced(
        fresh(),
        *(one for one in fresh_reports(T0 + 21) if one != battery(T0 + 21)),
        queue(T0 + 21),
        tick(T0 + 21),
    ),
}


@pytest.mark.parametrize("told", ODD)
def test_what_is_odd_is_amber_counted_and_found_by_its_key(told: str) -> None:
    state = ODD[told]
    rows = {row.key: row for row in fleet_table(state, R0, 100).rows}
    assert told in text_of(rows[R0].runs) and rows[R0].runs[0] == ("● ", StyleRole.WARN)
    assert rows[CALM].runs[0] == ("● ", StyleRole.GOOD)
    assert not state.alarms
    assert alarm_table(state, str, key="!").empty == "no alarms, 1 robot to look at (!)"
    assert "△ 0 alarms, 1 to look at  " in text_of(status_line(state, R0))
    alarmed = reduced(state, battery(state.now, 5.0, robot=CALM), tick(state.now))
    assert "▲ 1 alarm (1 new), 1 to look at  " in text_of(status_line(alarmed, R0))
    assert next_in_trouble(state, CALM) == R0
    assert "next_trouble" not in idle_hints(state)


@pytest.mark.parametrize(
    "state",
    [
        fresh(),
        fresh(
            *commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 9.9),
            PausedReported(R0, T0 + 10, True),
        ),
        fresh(ObstacleReported(R0, T0 + 10, 2.0)),
    ],
)
def test_what_is_usual_or_ordered_here_is_all_clear(state: FleetState) -> None:
    assert all(row.runs[0] == ("● ", StyleRole.GOOD) for row in fleet_table(state, R0, 100).rows)
    assert alarm_table(state, str, key="!").empty == "all clear"
    assert "look" not in text_of(status_line(state, R0))
    assert next_in_trouble(state, CALM) == "" and "next_trouble" in idle_hints(state)


def test_an_order_lost_a_minute_ago_is_no_news() -> None:
    later = reduced(lost(), *fresh_reports(T0 + 80), queue(T0 + 80), tick(T0 + 80))
    assert next_in_trouble(later, CALM) == ""
