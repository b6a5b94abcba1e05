"""Questions before a request is sent, and the origin of an order."""

import pytest

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request, chain
from fleet_tui.text.language import Message
from fleet_tui.ui.view.lines.questions import losses, question, request_text
from tests.support.fleets import R0, T0, fleet, graph, labels, place_order, queue, reduced

STATE = reduced(
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
        Problem("offline", Message("robot_0 is offline 41 s"), False),
        Problem("paused", Message("it is paused"), False),
    ]
    asked = question(STATE, Request((place_order(R0, 1, 2),)), found)
    assert asked == "robot_0 is offline 41 s, it is ␛paused: send anyway?\nrobot_0 order Base -> Store"
    assert question(STATE, Request((CancelOrder(R0, "4"),)), found[:1]).endswith("\nrobot_0 is offline 41 s")


def test_a_long_queue_is_cut_in_the_question_with_how_much_more_there_is() -> None:
    state = reduced(STATE, queue(T0, *((n, 1, 2, "Q") for n in range(1, 10))))
    lines = list(losses(state, Request((ClearOrders(R0),))))
    assert len(lines) == 8 and lines[-1] == "  and 3 more"


def test_a_wish_in_one_line() -> None:
    assert (
        request_text(STATE, Request(chain(R0, ["1", "2", "3"]))) == "robot_0 order Base -> Store, Store -> 3"
    )
    assert request_text(STATE, Request((PauseRobot(R0), PauseRobot("robot_1")))) == "pause all"
