"""Orders kept here for robots that drive one goal at a time: when one leaves, what pauses do."""

from itertools import count

import pytest
from msgspec.structs import replace

from fleet_tui.commands.checks import problems
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import FloorReported, GoalsReported
from fleet_tui.model.order import OrderState
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.orders.local_queue import next_to_send, waiting, withdrawn
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.view.lines.questions import question
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    of_kinds,
    place_order,
    pose,
    text_of,
    tick,
)
from tests.support.fleets import reduced as after
from tests.support.kinds import KEEPING

ORDER_1, ORDER_2 = place_order(R0, "2"), place_order(R0, "1")
KNOWN = (graph(1, 2), labels({1: "Base", 2: "Store"}))


def goals(at: float, state: OrderState) -> GoalsReported:
    return GoalsReported(R0, at, "navigate_to_pose", (Goal("3f2a", "3f2a-77", "navigate_to_pose", state),))


def test_a_pause_that_follows_while_an_order_is_still_being_written_down_overtakes_it() -> None:
    begun = of_kinds(fleet(), KEEPING), *KNOWN, link_up(T0), pose(T0), tick(T0)
    order = commanded(1, ORDER_1, Stage.CHECKED, at=T0)
    pause = commanded(2, PauseRobot(R0), Stage.SENT, at=T0 + 0.1)
    assert withdrawn(after(*begun, *order, *pause), 1, since=T0 + 0.3) == "robot paused before it was sent"
    earlier = after(*begun, *commanded(2, PauseRobot(R0), Stage.SENT, at=T0 - 0.1), *order)
    assert withdrawn(earlier, 1, since=T0) == ""


def test_what_the_link_knows_of_an_unanswered_goal_is_told_in_the_end() -> None:
    begun = of_kinds(fleet(), KEEPING), *KNOWN, link_up(T0), pose(T0), tick(T0)
    sent = after(*begun, *commanded(1, ORDER_1, Stage.SENT))
    late = T0 + sent.limits.confirm_after
    waits = after(sent, pose(late), goals(late, OrderState.DONE), tick(late + 0.1))
    assert waits.commands[-1].stage is Stage.SENT
    why = Message("the broker did not pass it on")
    told = after(waits, CommandAdvanced(1, Stage.NO_ANSWER, late + 0.2, why))
    end = late + 0.2 + sent.limits.confirm_after
    ended = after(told, pose(end), tick(end)).commands[-1]
    assert ended.stage is Stage.NOT_CONFIRMED and why in ended.detail


def ours(*facts: Event) -> FleetState:
    """The first order is driven, a second one waiting here."""
    begun: list[Event] = [*KNOWN, link_up(T0), pose(T0), tick(T0), *commanded(1, ORDER_1, Stage.SENT)]
    driving: list[Event] = [goals(T0 + 0.1, OrderState.IN_PROCESS), pose(T0 + 0.2), tick(T0 + 0.2)]
    waits = commanded(2, ORDER_2, Stage.WAITING, at=T0 + 0.2)
    return after(of_kinds(fleet(), KEEPING), *begun, *driving, *waits, *facts)


def record(state: FleetState, id_: int) -> CommandRecord:
    return next(one for one in state.commands if one.id == id_)


def leaving(state: FleetState) -> CommandRecord | None:
    return next_to_send(state, state.robots[R0])


def test_the_next_one_leaves_when_the_one_before_is_done() -> None:
    state = ours(goals(T0 + 1, OrderState.DONE), pose(T0 + 3), tick(T0 + 3))
    assert record(state, 1).stage is Stage.DONE
    assert leaving(state) == record(state, 2)


@pytest.mark.parametrize("end", [Stage.REFUSED, Stage.NOT_SENT])
def test_nothing_leaves_between_a_failure_and_the_tick_that_holds_the_queue(end: Stage) -> None:
    begun: list[Event] = [*KNOWN, link_up(T0), pose(T0), tick(T0)]
    first = commanded(1, ORDER_1, *([Stage.SENT] if end is Stage.REFUSED else []))
    state = after(of_kinds(fleet(), KEEPING), *begun, *first, *commanded(2, ORDER_2, Stage.WAITING))
    assert leaving(state) is None
    state = after(state, CommandAdvanced(1, end, T0 + 0.05))
    assert leaving(state) is None and not state.robots[R0].held
    assert after(state, tick(T0 + 0.1)).robots[R0].held == f"previous order: {end.value}"


@pytest.mark.parametrize("removal", [CancelOrder(R0, "3f2a"), ClearOrders(R0)])
def test_what_was_cancelled_while_a_pause_stopped_it_does_not_come_back(removal: Command) -> None:
    pause = commanded(3, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 0.3)
    cancel = commanded(4, removal, Stage.SENT, Stage.ACCEPTED, at=T0 + 0.4)
    ended: list[Event] = [goals(T0 + 0.6, OrderState.CANCELLED), pose(T0 + 2), tick(T0 + 2)]
    state = ours(*pause, *cancel, *ended)
    assert record(state, 1).stage is Stage.CANCELLED
    assert [one.id for one in waiting(state, state.robots[R0])] == [2]
    assert record(ours(*pause, *ended), 1).stage is Stage.WAITING


def test_a_robot_that_moves_on_without_a_goal_has_not_stopped() -> None:
    pause = commanded(3, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 0.3)
    times = [T0 + 0.4 + 0.1 * n for n in range(100)]
    stopped = goals(T0 + 0.6, OrderState.CANCELLED)
    moving = [fact for at, x in zip(times, count()) for fact in (pose(at, x), tick(at))]
    standing = [fact for at in times for fact in (pose(at), tick(at))]
    state = ours(pose(T0 + 0.25, 1.0), *pause, stopped, *moving)
    assert record(state, 3).stage is Stage.NOT_CONFIRMED
    assert record(state, 3).detail == "accepted; the robot was not seen to stop"
    state = ours(pose(T0 + 0.25, 1.0), *pause, stopped, *standing)
    assert (record(state, 3).stage, record(state, 3).detail) == (Stage.CONFIRMED, "stopped, goal kept here")


def test_one_of_several_stops_is_done_without_its_answer_and_says_what_is_not_known() -> None:
    several = Goal("3f2a", "3f2a-77", "follow_waypoints", OrderState.IN_PROCESS, leads=True)
    begun: list[Event] = [*KNOWN, link_up(T0), pose(T0), tick(T0)]
    begun += commanded(1, place_order(R0, "1", "2"), Stage.SENT)
    driving = GoalsReported(R0, T0 + 0.1, several.action, (several,))
    done = Goal("3f2a", "3f2a-77", "follow_waypoints", OrderState.DONE, leads=True)
    ended: list[Event] = [GoalsReported(R0, T0 + 1, several.action, (done,)), pose(T0 + 3), tick(T0 + 3)]
    state = after(of_kinds(fleet(), KEEPING), *begun, driving, pose(T0 + 0.2), tick(T0 + 0.2), *ended)
    assert record(state, 1).stage is Stage.DONE
    assert "stops may have been missed" in record(state, 1).detail


def test_a_question_names_the_orders_that_wait_here_too() -> None:
    state = ours()
    asked = question(state, Request((ClearOrders(R0),)), [])
    assert asked == "Clear all 2 orders of robot_0?\n  3f2a  -> Store\n  k1  -> Base"
    asked = question(state, Request((CancelOrder(R0, "k1"),)), [])
    assert asked == "Cancel order k1 of robot_0?\n-> Base"


def test_a_clear_takes_back_no_order_of_others() -> None:
    foreign = GoalsReported(
        R0, T0, "navigate_to_pose", (Goal("77", "77-1", "navigate_to_pose", OrderState.IN_PROCESS),)
    )
    state = after(of_kinds(fleet(), KEEPING), *KNOWN, link_up(T0), pose(T0), foreign, tick(T0 + 0.1))
    (problem,) = problems(state, Request((ClearOrders(R0),)), Permissions())
    assert (problem.text, problem.blocks) == ("robot_0 has no orders of this console", True)
    waits = after(state, *commanded(2, ORDER_2, Stage.WAITING, at=T0 + 0.2))
    assert question(waits, Request((ClearOrders(R0),)), []) == "Clear all 1 order of robot_0?\n  k1  -> Base"


def test_orders_that_wait_here_are_orders_and_a_resume_says_whether_there_are_any() -> None:
    state = ours(goals(T0 + 1, OrderState.CANCELLED), pose(T0 + 3), tick(T0 + 3))
    assert "1 waiting" in text_of(fleet_table(state, "", 80).title)
    assert state.robots[R0].held and "no orders" not in [one.name for one in reasons(state, state.robots[R0])]
    resume = commanded(3, ResumeRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 3)
    assert record(after(state, *resume, tick(T0 + 3.1)), 3).detail == "waiting orders continue"
    emptied = after(state, CommandAdvanced(2, Stage.CANCELLED, T0 + 3))
    assert record(after(emptied, *resume, tick(T0 + 3.1)), 3).detail == "no orders waiting here"


def test_orders_that_wait_for_a_robot_that_left_its_floor_are_held() -> None:
    there = fleet(floors=2)
    known = [graph(1, 2), graph(1, 2, floor="floor_1")]
    kind = replace(KEEPING, frames_are_floors=False)
    first: list[Event] = [*known, link_up(T0), FloorReported(R0, T0, "floor_0"), pose(T0), tick(T0)]
    state = after(of_kinds(there, kind), *first, *commanded(1, ORDER_1, Stage.WAITING))
    assert leaving(state) is not None
    state = after(state, FloorReported(R0, T0 + 0.1, "floor_1"), pose(T0 + 0.1))
    assert leaving(state) is None
    resume = commanded(2, ResumeRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0 + 0.2)
    for facts in ([tick(T0 + 0.1)], [tick(T0 + 0.1), *resume, tick(T0 + 0.3)]):
        then = after(state, *facts)
        assert then.robots[R0].held == "order k1 is for floor_0, robot_0 is on floor_1"
        assert leaving(then) is None


def test_a_queue_in_which_nothing_waits_any_more_is_not_held() -> None:
    state = ours(goals(T0 + 1, OrderState.FAILED), pose(T0 + 3), tick(T0 + 3))
    assert state.robots[R0].held
    assert not after(state, CommandAdvanced(2, Stage.CANCELLED, T0 + 3), tick(T0 + 3.1)).robots[R0].held


def test_a_robot_that_is_not_heard_is_not_said_to_have_stopped() -> None:
    pause = commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, detail="no action server")
    offline = after(of_kinds(fleet(), KEEPING), *KNOWN, link_up(T0), *pause)
    assert record(after(offline, tick(T0 + 0.1)), 1).stage is Stage.ACCEPTED
    ended = record(after(offline, *map(tick, (T0 + 0.1, T0 + 60))), 1)
    assert (ended.stage, ended.detail) == (Stage.NOT_CONFIRMED, "accepted; the robot is offline")
    assert record(after(offline, pose(T0 + 0.2), tick(T0 + 0.2)), 1).stage is Stage.CONFIRMED
