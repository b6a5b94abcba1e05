"""Tasks as the orders of robots: one at a time, moved between robots, interrupted and ended."""

import pytest

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import MemberReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import Alive
from fleet_tui.model.order import OrderState
from fleet_tui.orders.goals import LISTED_FOR
from tests.support.fleets import F0, R0, T0, reduced, tick
from tests.support.rmf import DONE, ON, QUEUED, reported, rmf_fleet

R1 = "robot_1"


def listed(state: FleetState, robot: str = R0) -> list[tuple[str, OrderState | None]]:
    return [(one.id, one.state) for one in state.robots[robot].orders.orders]


def test_each_message_adds_or_changes_one_task() -> None:
    state = reduced(rmf_fleet(), reported(T0, "a"), reported(T0, "b", QUEUED), reported(T0 + 1, "a", DONE))
    assert listed(state) == [("a", DONE), ("b", QUEUED)]
    (gone,) = state.robots[R0].gone
    assert (gone.order.id, gone.reason) == ("a", "as reported by the robot")
    assert listed(reduced(state, tick(T0 + 2 + LISTED_FOR))) == [("b", QUEUED)]


def test_a_task_that_moves_to_another_robot_is_neither_lost_nor_twice() -> None:
    state = reduced(rmf_fleet(), reported(T0, "a", QUEUED), reported(T0 + 1, "a", robot=R1))
    assert (listed(state), listed(state, R1)) == ([], [("a", ON)])
    assert not state.robots[R0].gone
    state = reduced(state, reported(T0 + 2, "a", robot="of another console"))
    assert (listed(state), listed(state, R1)) == ([], [])


def test_what_had_ended_before_we_came_is_no_order() -> None:
    assert listed(reduced(rmf_fleet(), reported(T0, "a", DONE), reported(T0, "b", DONE))) == []


def test_an_interrupted_task_pauses_its_robot_until_it_is_resumed_or_over() -> None:
    held = reported(T0, "a", OrderState.PAUSED, tokens=("7",))
    state = reduced(rmf_fleet(), Alive(R0, T0), held, tick(T0))
    assert state.is_paused(state.robots[R0])
    for after in (reported(T0 + 1, "a"), reported(T0 + 1, "a", OrderState.CANCELLED)):
        again = reduced(state, Alive(R0, T0 + 1), after, tick(T0 + 1))
        assert not again.is_paused(again.robots[R0])


def test_a_robot_without_any_task_is_not_said_to_be_unpaused() -> None:
    assert rmf_fleet().robots[R0].paused is None


def test_the_estimate_is_its_progress_and_no_sign_of_life() -> None:
    robot = reduced(rmf_fleet(), reported(T0, "a")).robots[R0]
    assert robot.progress is None and robot.last_received is None


def driving(at: float, task: str, mode: str = "moving") -> MemberReported:
    return MemberReported(R0, at, Pose(0.0, 0.0), F0, at, 80.0, mode, task)


def states(state: FleetState) -> list[OrderState | None]:
    return [one.state for one in state.robots[R0].orders.orders]


def test_a_task_whose_end_was_missed_is_lost_not_done_after_a_minute() -> None:
    state = reduced(rmf_fleet(), reported(T0, "a"), driving(T0 + 50, "b"), tick(T0 + 50))
    assert states(state) == [ON]
    state = reduced(state, driving(T0 + 61, "b"), tick(T0 + 61))
    assert states(state) == [OrderState.LOST]
    assert "unknown whether it was done" in state.robots[R0].orders.orders[0].said
    assert states(reduced(state, reported(T0 + 62, "a"))) == [ON]


@pytest.mark.parametrize("later", [62.0, 80.0])
def test_a_lost_task_whose_end_is_reported_later_has_that_end(later: float) -> None:
    """Also when it is no longer listed: its end is news."""
    state = reduced(rmf_fleet(), reported(T0, "a"), driving(T0 + 61, "b"), tick(T0 + 61))
    assert [gone.stage for gone in state.robots[R0].gone] == [Stage.LOST]
    state = reduced(state, driving(T0 + later, "b"), tick(T0 + later), reported(T0 + later, "a", DONE))
    assert [gone.stage for gone in state.robots[R0].gone] == [Stage.DONE]


def test_a_task_is_not_lost_while_it_is_driven_or_while_its_adapter_is_silent() -> None:
    state = reduced(rmf_fleet(), reported(T0, "a"), driving(T0 + 300, "a"), tick(T0 + 300))
    assert states(state) == [ON]
    silent = reduced(rmf_fleet(), reported(T0, "a"), driving(T0, "b"), tick(T0 + 300))
    assert states(silent) == [ON]


def test_a_waiting_task_of_an_idle_robot_is_lost_only_after_an_hour() -> None:
    state = reduced(rmf_fleet(), reported(T0, "a", QUEUED), driving(T0 + 900, "", "idle"), tick(T0 + 900))
    assert states(state) == [QUEUED]
    state = reduced(state, driving(T0 + 3700, "", "idle"), tick(T0 + 3700))
    assert states(state) == [OrderState.LOST]
