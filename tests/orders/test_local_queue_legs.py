"""Stops that this console has still to give: what keeps the next goal from leaving."""

import pytest

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.orders.local_queue import all_orders, hold_all, next_to_send
from fleet_tui.situation.pauses import foreign_stopped
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, link_lost, link_up, reduced, tick
from tests.support.legs import DONE, OFF, goal, lived, record, sent, site

FIRST = "goal---1"


def on_its_first_leg() -> FleetState:
    return lived(sent(site(), T0 + 1, FIRST), T0 + 1.2, goal(FIRST))


def asked(state: FleetState, at: float, command: Command) -> FleetState:
    """After a command that was published, to which nothing answers."""
    issued = CommandIssued(8, command, at, T0)
    steps = [CommandAdvanced(8, stage, at) for stage in (Stage.SENT, Stage.ACCEPTED)]
    return reduced(state, issued, *steps)


def leaves(state: FleetState) -> bool:
    return next_to_send(state, state.robots[R0]) is not None


@pytest.mark.parametrize("command", [CancelOrder(R0, FIRST), ClearOrders(R0)])
def test_after_a_cancel_that_nothing_showed_no_further_goal_leaves(command: Command) -> None:
    state = asked(on_its_first_leg(), T0 + 1.5, command)
    state = lived(state, T0 + 30, goal(FIRST))
    assert record(state, 8).stage is Stage.NOT_CONFIRMED
    state = lived(state, T0 + 31, goal(FIRST, DONE))
    assert record(state).stage is Stage.CANCELLED and not leaves(state)


def test_a_clear_takes_back_a_goal_that_is_not_listed_yet() -> None:
    for end in (OFF, DONE):
        state = asked(sent(site(), T0 + 1, FIRST), T0 + 1.1, ClearOrders(R0))
        state = lived(lived(state, T0 + 1.3, goal(FIRST)), T0 + 2, goal(FIRST, end))
        assert record(state).stage is Stage.CANCELLED and not leaves(state)


def test_a_link_that_was_lost_on_the_way_holds_the_next_stop() -> None:
    state = reduced(on_its_first_leg(), link_lost(T0 + 2))
    state = reduced(state, tick(T0 + 2.1), link_up(T0 + 3))
    state = lived(state, T0 + 3.2, goal(FIRST, DONE))
    assert record(state).stage is Stage.WAITING
    assert state.robots[R0].held == "the link was lost" and not leaves(state)


def test_a_console_that_is_disarmed_on_the_way_holds_the_next_stop() -> None:
    state = on_its_first_leg()
    state = reduced(state, *hold_all(state, Message("this console is not armed")))
    state = lived(lived(state, T0 + 1.5, goal(FIRST)), T0 + 2, goal(FIRST, DONE))
    assert record(state).stage is Stage.WAITING
    assert state.robots[R0].held == "this console is not armed" and not leaves(state)


def test_a_goal_that_reached_its_stop_is_not_shown_as_the_whole_order_done() -> None:
    state = lived(on_its_first_leg(), T0 + 2, goal(FIRST, DONE))
    shown = [(order.stops, order.state_text) for order in all_orders(state, state.robots[R0])]
    assert shown == [(at_vertices("1"), "done"), (at_vertices("1", "2"), "waiting here")]


def test_a_clear_is_not_confirmed_while_a_goal_that_it_takes_back_may_still_appear() -> None:
    state = asked(sent(site(), T0 + 1, FIRST), T0 + 1.1, ClearOrders(R0))
    state = lived(state, T0 + 1.2)
    assert record(state, 8).stage is Stage.ACCEPTED
    driven = lived(state, T0 + 1.4, goal(FIRST))
    assert record(driven, 8).stage is Stage.ACCEPTED
    assert record(lived(driven, T0 + 2, goal(FIRST, OFF)), 8).stage is Stage.CONFIRMED
    never = lived(lived(state, T0 + 30), T0 + 30.1)
    assert [record(never, one).stage for one in (7, 8)] == [Stage.NOT_CONFIRMED, Stage.CONFIRMED]


def test_a_pause_that_stops_a_goal_of_others_says_so_though_orders_wait_here() -> None:
    state = reduced(site(), CommandIssued(7, PlaceOrder(R0, at_vertices("2")), T0 + 1, T0))
    state = reduced(lived(state, T0 + 1.1, goal("another1")), CommandAdvanced(7, Stage.WAITING, T0 + 1.2))
    state = asked(lived(state, T0 + 1.3, goal("another1")), T0 + 2, PauseRobot(R0))
    state = lived(lived(state, T0 + 2.2, goal("another1", OFF)), T0 + 2.4, goal("another1", OFF))
    pause = record(state, 8)
    assert (pause.stage, pause.detail) == (Stage.CONFIRMED, foreign_stopped(Message("goal another1")))


def test_a_resume_after_which_an_order_left_says_so() -> None:
    state = asked(on_its_first_leg(), T0 + 2, PauseRobot(R0))
    state = lived(lived(state, T0 + 2.2, goal(FIRST, OFF)), T0 + 4, goal(FIRST, OFF))
    assert (record(state, 8).detail, record(state).stage) == ("stopped, goal kept here", Stage.WAITING)
    resume = [CommandAdvanced(9, stage, T0 + 5) for stage in (Stage.SENT, Stage.ACCEPTED)]
    state = sent(reduced(state, CommandIssued(9, ResumeRobot(R0), T0 + 5, T0), *resume), T0 + 5, "goal---2")
    state = lived(state, T0 + 5.1, goal(FIRST, OFF))
    assert record(state, 9).detail == "waiting orders continue"
