"""Orders of any stack: text ids, stops that are vertices or poses, states in words, ends."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.commands import (
    FAILURES,
    NEXT,
    OPEN,
    ORDER_ENDS,
    CancelOrder,
    CommandRecord,
    PlaceOrder,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced, Event, QueueReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import (
    OVER,
    PENDING,
    Order,
    OrderQueue,
    OrderState,
    Stop,
    at_vertices,
    natural,
    route_text,
)
from fleet_tui.situation.pauses import WAITS
from tests.support.fleets import R0, T0, commanded, fleet, graph, link_up, place_order, pose, reduced, tick

GOAL = "3f2a-77"
ORDER = place_order(R0, "dock A", "7b")


def reported(at: float, *orders: Order, current: str = "", last: int = 0) -> QueueReported:
    last = max((one.serial for one in orders), default=last)
    return QueueReported(R0, at, OrderQueue(last, current, orders))


def goal(state: OrderState | None, word: str = "", stops: tuple[Stop, ...] = ORDER.stops) -> Order:
    return Order(GOAL, stops, state, word, 1)


def confirmed(*facts: Event) -> FleetState:
    """The order of this console is the robot's goal."""
    begun = [link_up(T0 - 9), reported(T0 - 1), tick(T0), *commanded(1, ORDER, Stage.SENT, Stage.ACCEPTED)]
    driving = reported(T0 + 1, goal(OrderState.IN_PROCESS), current=GOAL)
    return reduced(fleet(), *begun, driving, tick(T0 + 1), *facts)


def only(state: FleetState) -> CommandRecord:
    (record,) = state.commands
    return record


def test_every_state_is_pending_or_over() -> None:
    assert set(OrderState) == PENDING | OVER and not PENDING & OVER
    assert {
        OrderState.DONE,
        OrderState.CANCELLED,
        OrderState.LOST,
        OrderState.FAILED,
        OrderState.REPLACED,
        OrderState.REFUSED,
    } == OVER


@pytest.mark.parametrize(
    ("stops", "text"),
    [
        ((), "to a point"),
        (at_vertices("b"), "-> B"),
        (at_vertices("a", "b"), "A -> B"),
        (at_vertices("a", "b", "c"), "A -> B -> C"),
        ((Stop(pose=Pose(1.25, -3.41)),), "-> (1.2, -3.4)"),
        ((Stop("a"), Stop(pose=Pose(0.0, 2.0))), "A -> (0.0, 2.0)"),
    ],
)
def test_an_order_is_written_by_its_stops(stops: tuple[Stop, ...], text: str) -> None:
    assert route_text(stops, str.upper) == text


def test_ends_of_an_order() -> None:
    one, two, none = (replace(goal(None), stops=at_vertices(*ids)) for ids in ("b", "ab", ""))
    assert (one.start, one.end) == (None, Stop("b"))
    assert (two.start, two.end) == (Stop("a"), Stop("b"))
    assert (none.start, none.end) == (None, None)


def test_two_comes_before_ten() -> None:
    assert sorted(["10", "2", "b10", "b2", "a", "", "1x", "01"], key=natural) == [
        "",
        "01",
        "1x",
        "2",
        "10",
        "a",
        "b2",
        "b10",
    ]


@given(st.lists(st.text(max_size=5) | st.sampled_from(["9" * 5000, "٣", "a9" * 900]), max_size=9))
def test_any_ids_have_an_order_and_equal_ones_stand_together(ids: list[str]) -> None:
    keys = [natural(id_) for id_ in sorted(ids * 2, key=natural)]
    assert all(one <= other for one, other in pairwise(keys))


@given(st.lists(st.integers(0, 10**9)))
def test_numbers_stand_as_numbers_do(numbers: list[int]) -> None:
    assert sorted(map(str, numbers), key=natural) == list(map(str, sorted(numbers)))


def test_an_order_with_ids_of_text_is_recognised_and_told() -> None:
    record = only(confirmed())
    assert (record.stage, record.order_id, record.order_serial) == (Stage.CONFIRMED, GOAL, 1)
    assert record.detail == f"seen in the queue as order {GOAL}"


@pytest.mark.parametrize(
    ("state", "stage"),
    [
        (OrderState.DONE, Stage.DONE),
        (OrderState.CANCELLED, Stage.CANCELLED_ELSEWHERE),
        (OrderState.LOST, Stage.LOST),
        (OrderState.FAILED, Stage.FAILED),
        (OrderState.REPLACED, Stage.REPLACED),
        (OrderState.REFUSED, Stage.FAILED),
    ],
)
def test_an_order_that_is_listed_as_over_ended_so(state: OrderState, stage: Stage) -> None:
    ended = confirmed(reported(T0 + 2, goal(state)), tick(T0 + 3))
    assert only(ended).stage is stage and stage in ORDER_ENDS
    alarms = [alarm.text for alarm in ended.alarms if alarm.condition.kind == "command"]
    assert bool(alarms) == (stage in FAILURES)
    if stage is Stage.FAILED:
        assert alarms == ["order dock A -> 7b failed: no reason reported"]
    if stage is Stage.REPLACED:
        assert alarms == [f"replaced: order dock A -> 7b (order {GOAL}: as reported by the robot)"]


def test_what_the_robot_says_of_its_end_counts_more_than_our_cancel() -> None:
    for state, stage in ((OrderState.FAILED, Stage.FAILED), (OrderState.REPLACED, Stage.REPLACED)):
        cancel = commanded(2, CancelOrder(R0, GOAL), Stage.SENT, Stage.ACCEPTED, at=T0 + 1.5)
        ended = confirmed(*cancel, reported(T0 + 2, goal(state)), tick(T0 + 2))
        assert ended.commands[0].stage is stage


def test_an_order_that_waits_here_is_not_the_one_that_the_robot_took() -> None:
    begun = reduced(fleet(), link_up(T0 - 9), reported(T0 - 1), tick(T0))
    unseen = reduced(begun, *commanded(1, ORDER, Stage.SENT, Stage.NO_ANSWER))
    late = reduced(unseen, reported(T0 + 1), tick(T0 + 90))
    assert only(late).stage is Stage.NOT_CONFIRMED
    state = reduced(late, *commanded(2, ORDER, Stage.WAITING, at=T0 + 91))
    state = reduced(state, reported(T0 + 92, goal(OrderState.QUEUED)), tick(T0 + 92))
    assert [record.stage for record in state.commands] == [Stage.LATE, Stage.WAITING]


def test_an_id_that_a_robot_gives_again_after_it_was_started_anew_is_another_order() -> None:
    restarted = confirmed(reported(T0 + 2), tick(T0 + 2))
    assert only(restarted).stage is Stage.LOST
    again = commanded(2, ORDER, Stage.SENT, Stage.ACCEPTED, at=T0 + 3)
    state = reduced(restarted, *again, reported(T0 + 4, goal(OrderState.QUEUED)), tick(T0 + 4))
    assert (state.commands[1].stage, state.commands[1].order_id) == (Stage.CONFIRMED, GOAL)


def test_a_word_that_says_nothing_to_us_is_an_order_that_goes_on() -> None:
    state = confirmed(reported(T0 + 2, goal(None, "ROUNDABOUT"), current=GOAL), tick(T0 + 2))
    assert only(state).stage is Stage.CONFIRMED
    assert state.robots[R0].orders.open[0].state_text == "ROUNDABOUT"


def test_an_order_to_a_pose_is_done_where_the_robot_was_there() -> None:
    stops = (Stop(pose=Pose(3.0, 0.0)),)
    begun: list[Event] = [link_up(T0 - 9), reported(T0 - 1), pose(T0), tick(T0)]
    asked = commanded(1, PlaceOrder(R0, stops), Stage.SENT, Stage.ACCEPTED)
    driving = [reported(T0 + n, goal(OrderState.IN_PROCESS, stops=stops), current=GOAL) for n in (1, 2)]
    state = reduced(fleet(), *begun, *asked, driving[0], tick(T0 + 1), pose(T0 + 2, 3.0), driving[1])
    assert only(reduced(state, reported(T0 + 2.5, last=1), tick(T0 + 3))).stage is Stage.DONE
    left = reduced(fleet(), *begun, *asked, driving[0], tick(T0 + 1), pose(T0 + 2, 30.0), driving[1])
    assert only(reduced(left, reported(T0 + 2.5, last=1), tick(T0 + 4))).detail.endswith("27 m from its end")


def test_no_queue_current_and_an_empty_id_is_none() -> None:
    assert OrderQueue(1, "", (Order("", (), None, "", 1),)).current is None


def test_waiting_here_is_open_but_telemetry_does_not_decide_it() -> None:
    assert Stage.WAITING in OPEN and Stage.WAITING not in WAITS
    assert NEXT[Stage.WAITING] == {Stage.WAITING, Stage.SENT, Stage.NOT_SENT, Stage.CANCELLED}
    waiting = reduced(fleet(), link_up(T0), *commanded(1, ORDER, Stage.WAITING), tick(T0 + 900))
    assert only(waiting).stage is Stage.WAITING and not only(waiting).is_decided
    cancelled = only(reduced(waiting, CommandAdvanced(1, Stage.CANCELLED, T0 + 901)))
    assert cancelled.is_decided and cancelled.outcome == cancelled.steps[-1]


def test_an_order_that_was_stopped_and_waits_here_is_sent_and_recognised_again() -> None:
    kept = confirmed(CommandAdvanced(1, Stage.WAITING, T0 + 2), reported(T0 + 2, goal(OrderState.CANCELLED)))
    assert not only(kept).is_decided and only(kept).outcome is None and not only(kept).has_open_order
    again = replace(goal(OrderState.IN_PROCESS), id="second", serial=2)
    sent = reduced(
        kept, tick(T0 + 3), CommandAdvanced(1, Stage.SENT, T0 + 4), CommandAdvanced(1, Stage.ACCEPTED, T0 + 4)
    )
    state = reduced(sent, reported(T0 + 5, goal(OrderState.CANCELLED), again, current="second"), tick(T0 + 5))
    assert (only(state).stage, only(state).order_id) == (Stage.CONFIRMED, "second")
    assert only(state).outcome == only(state).steps[-1]


def test_graphs_with_ids_of_text_lead_from_one_to_the_other() -> None:
    routes = graph("dock A", "b-2", "7b").graph
    assert routes.path("dock A", "7b") == ("dock A", "b-2", "7b")
