"""What is asked before a wish is sent, and where an order comes from."""

import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, Stage
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request, chain
from fleet_tui.view.lines.questions import losses, question, wish_text
from fleet_tui.view.tables.order_story import origin
from tests.support.fleets import R0, T0, commanded, fleet, graph, labels, place_order, queue, tick, told
from tests.support.fleets import order as listed

STATE = told(
    fleet(2), graph(1, 2, 3), labels({1: "Base", 2: "Store"}), queue(T0, (4, 1, 2, "W"), (5, 2, 1, "Q"))
)


@pytest.mark.parametrize(
    ("commands", "asked"),
    [
        ((CancelOrder(R0, "4"),), "Cancel order 4 of robot_0?\nBase -> Store"),
        ((ClearOrders(R0),), "Clear all 2 orders of robot_0?\n  4  Base -> Store\n  5  Store -> Base"),
        ((place_order(R0, 1, 2),), "Send?\nrobot_0 order Base -> Store"),
    ],
)
def test_what_will_be_lost_is_named(commands: tuple[Command, ...], asked: str) -> None:
    assert question(STATE, Request(commands), []) == asked


def test_warnings_stand_in_the_question() -> None:
    found = [
        Problem("offline", "robot_0 is offline 41 s", False),
        Problem("paused", "it is \x1bpaused", False),
    ]
    asked = question(STATE, Request((place_order(R0, 1, 2),)), found)
    assert asked == "robot_0 is offline 41 s, it is ␛paused: send anyway?\nrobot_0 order Base -> Store"
    assert question(STATE, Request((CancelOrder(R0, "4"),)), found[:1]).endswith("\nrobot_0 is offline 41 s")


def test_a_long_queue_is_cut_in_the_question_with_how_much_more_there_is() -> None:
    state = told(STATE, queue(T0, *((n, 1, 2, "Q") for n in range(1, 10))))
    lines = list(losses(state, Request((ClearOrders(R0),))))
    assert len(lines) == 8 and lines[-1] == "  and 3 more"


def test_a_wish_in_one_line() -> None:
    assert wish_text(STATE, Request(chain(R0, ["1", "2", "3"]))) == "robot_0 order Base -> Store, Store -> 3"
    assert wish_text(STATE, Request((PauseRobot(R0), PauseRobot("robot_1")))) == "pause all"


def at(wall: float) -> str:
    return "12:04:31"


def test_an_order_is_ours_anothers_or_perhaps_ours() -> None:
    given = place_order(R0, 1, 2)
    placed = commanded(7, given, Stage.SENT, Stage.ACCEPTED, at=T0 + 1)
    state = told(STATE, *placed, queue(T0 + 2, (4, 1, 2, "W"), (6, 1, 2, "Q")), tick(T0 + 2.1))
    assert origin(state, R0, listed(6, 1, 2, "Q"), at) == "sent here at 12:04:31, accepted, confirmed"
    assert origin(state, R0, listed(4, 1, 2, "W"), at) == "not sent by this console"
    unsure = told(fleet(), *commanded(7, given, Stage.SENT, Stage.UNKNOWN))
    assert origin(unsure, R0, listed(6, 1, 2, "Q"), at) == "possibly sent here at 12:04:31, outcome unknown"
    assert origin(unsure, R0, listed(6, 2, 1, "Q"), at) == "not sent by this console"
    refused = told(fleet(), *commanded(7, given, Stage.SENT, Stage.REFUSED))
    assert origin(refused, R0, listed(6, 1, 2, "Q"), at) == "not sent by this console"
    loaded = told(fleet(), *commanded(7, place_order(R0, 2), Stage.SENT))
    assert origin(loaded, R0, listed(6, 9, 2, "Q"), at) == "possibly sent here at 12:04:31, sent"


def test_who_gave_an_order_is_known_as_long_as_it_is_in_the_queue() -> None:
    placed = commanded(7, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, at=T0 + 1)
    state = told(STATE, *placed, queue(T0 + 2, (6, 1, 2, "Q")), tick(T0 + 2.1))
    for n in range(300):
        state = told(state, *commanded(100 + n, PauseRobot(R0), Stage.NOT_SENT))
    assert len(state.commands) == 200
    assert origin(state, R0, listed(6, 1, 2, "Q"), at).startswith("sent here")
