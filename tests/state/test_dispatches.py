"""Answers of dispatchers: to whose request, and what they make of it."""

from fleet_tui.model.commands import CommandRecord, PauseRobot, PlaceOrder, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import DispatchFailed, RequestAnswered
from fleet_tui.model.order import at_vertices
from tests.support.fleets import R0, T0, WALL, reduced, tick
from tests.support.rmf import QUEUED, reported, rmf_fleet

ORDER = PlaceOrder(R0, at_vertices("A"), to_any=True)


def sent(command: PlaceOrder | PauseRobot = ORDER) -> FleetState:
    issued = CommandIssued(7, command, T0, WALL)
    return reduced(rmf_fleet(), issued, CommandAdvanced(7, Stage.SENT, T0, name="q"))


def record(state: FleetState) -> CommandRecord:
    return state.commands[0]


def test_an_answer_to_another_request_changes_nothing() -> None:
    state = sent()
    assert reduced(state, RequestAnswered("x", T0, Stage.ACCEPTED, "", "t")) is state
    assert reduced(state, DispatchFailed("", T0, "why")) is state


def test_an_accepted_order_is_found_by_its_task_wherever_it_is() -> None:
    state = reduced(sent(), RequestAnswered("q", T0 + 1, Stage.ACCEPTED, "", "t-1"))
    assert (record(state).stage, record(state).name) == (Stage.ACCEPTED, "t-1")
    state = reduced(state, reported(T0 + 2, "t-1", QUEUED, robot="robot_1"), tick(T0 + 2))
    assert (record(state).stage, record(state).command.robot) == (Stage.CONFIRMED, "robot_1")
    assert state.robots["robot_1"].orders.open[0].stops == ORDER.stops


def test_an_order_is_found_by_its_requester_without_any_answer() -> None:
    state = reduced(sent(), CommandAdvanced(7, Stage.NO_ANSWER, T0 + 1))
    state = reduced(state, reported(T0 + 2, "t-1", QUEUED, requester="q"), tick(T0 + 2))
    assert record(state).stage is Stage.CONFIRMED


def test_one_that_no_fleet_took_is_refused() -> None:
    state = reduced(sent(), RequestAnswered("q", T0, Stage.ACCEPTED, "", "t-1"))
    state = reduced(state, DispatchFailed("t-1", T0 + 3, "no fleet took the task"))
    assert (record(state).stage, record(state).detail) == (Stage.REFUSED, "no fleet took the task")


def test_fleets_may_bid_longer_than_a_robot_may_answer() -> None:
    state = reduced(sent(), RequestAnswered("q", T0, Stage.ACCEPTED, "", "t-1"), tick(T0 + 10))
    assert record(state).stage is Stage.ACCEPTED
    assert record(reduced(state, tick(T0 + 21))).stage is Stage.NOT_CONFIRMED


def test_a_pause_keeps_its_own_name() -> None:
    state = reduced(sent(PauseRobot(R0)), RequestAnswered("q", T0, Stage.ACCEPTED, "", "t-1"))
    assert record(state).name == "q" and state.robots[R0].named == ""
