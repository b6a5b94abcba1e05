"""Orders that leave the queue: done unless there is evidence against it, and the evidence."""

import math
from collections.abc import Mapping

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Stage
from fleet_tui.model.order import Order, OrderQueue, OrderState, at_vertices
from fleet_tui.model.order_life import (
    ARRIVES,
    LEFT_WITHIN,
    NOT_LISTED,
    SEEN_AGAIN,
    STARTED_OVER,
    Away,
    GoneOrder,
    OrderTrace,
    latest,
    listed_end,
    trace_movement,
    trace_queue,
)
from fleet_tui.text.language import EMPTY

QUEUED = Order("5", at_vertices("1", "2"), OrderState.QUEUED, "Q", 5)
DRIVEN = replace(QUEUED, state=OrderState.IN_PROCESS)


def queue(*orders: Order, last: int = 5) -> OrderQueue:
    return OrderQueue(last, "", orders)


def away(metres: float, at: float) -> Away:
    return lambda _order: (metres, at)


def unplaced(_order: Order) -> None:
    return None


def end(
    trace: OrderTrace, now: OrderQueue, where: Away = unplaced, at: float = 12.0, received: float = 11.0
) -> tuple[Stage, str]:
    """The end of an order in a queue that comes at a second, the one before at `received`."""
    _, (gone,) = trace_queue({"5": trace}, now, at, (received, 5), where)
    return gone.stage, gone.reason


@pytest.mark.parametrize(
    ("trace", "now", "where", "stage", "reason"),
    [
        (OrderTrace(DRIVEN, True, 11.0), queue(), away(9.0, 12.0), Stage.DONE, "driven to the end"),
        (OrderTrace(QUEUED), queue(), unplaced, Stage.LEFT, "before it started"),
        (OrderTrace(DRIVEN, True), queue(), unplaced, Stage.DONE, "after it started"),
        (OrderTrace(DRIVEN, True), queue(), away(7.2, 12.0), Stage.LEFT, "the robot 7 m from its end"),
        (OrderTrace(DRIVEN, True), queue(), away(math.inf, 12.0), Stage.LEFT, "on another floor"),
        (OrderTrace(DRIVEN, True), queue(), away(7.0, 2.0), Stage.LOST, "no pose was received for 10 s"),
        (OrderTrace(DRIVEN, True, 11.0), queue(last=0), unplaced, Stage.LOST, STARTED_OVER),
        (
            OrderTrace(DRIVEN, True),
            queue(replace(DRIVEN, stops=at_vertices("3"))),
            unplaced,
            Stage.LOST,
            STARTED_OVER,
        ),
        (
            OrderTrace(DRIVEN, True),
            queue(replace(DRIVEN, state=OrderState.CANCELLED, said="by hand")),
            unplaced,
            Stage.CANCELLED,
            "by hand",
        ),
    ],
)
def test_the_evidence_decides(
    trace: OrderTrace, now: OrderQueue, where: Away, stage: Stage, reason: str
) -> None:
    found = end(trace, now, where)
    assert found[0] is stage and reason in found[1]


def test_a_visit_to_its_end_counts_only_shortly_before_it_left_the_queue() -> None:
    trace = OrderTrace(DRIVEN, True, arrived_at=10.0)
    assert trace.was_driven(None) and trace.was_driven(10.0 + LEFT_WITHIN)
    assert not trace.was_driven(10.1 + LEFT_WITHIN) and not OrderTrace(DRIVEN, True).was_driven(None)


def test_without_a_queue_for_long_it_may_have_been_completed() -> None:
    stage, reason = end(OrderTrace(DRIVEN, True), queue(), at=30.0)
    assert (stage, reason) == (
        Stage.LOST,
        "left the queue while no queue was received for 19 s: may have been completed",
    )


def test_a_robot_that_lists_ends_has_lost_what_it_lists_no_more() -> None:
    arrived = {"5": OrderTrace(DRIVEN, True, 11.9)}
    _, (gone,) = trace_queue(arrived, queue(), 12.0, (11.0, 5), unplaced, reports_ends=True)
    assert gone == GoneOrder(DRIVEN, 12.0, Stage.LOST, NOT_LISTED)


def test_an_order_stays_begun_and_the_echo_is_that_of_the_newest() -> None:
    other = replace(QUEUED, id="6", serial=6)
    first, _ = trace_queue({}, OrderQueue(5, "5", (QUEUED,), request_id=77), 1.0, None, unplaced)
    assert first["5"].begun and first["5"].request_id == 77
    later, gone = trace_queue(
        first, OrderQueue(6, "", (QUEUED, other), request_id=88), 2.0, (1.0, 5), unplaced
    )
    assert later["5"].begun and not gone
    assert (later["5"].request_id, later["6"].request_id) == (77, 88)


def test_an_arrival_is_that_of_an_order_begun_and_not_recorded_ten_times_a_second() -> None:
    traces: Mapping[str, OrderTrace] = {"5": OrderTrace(DRIVEN, True), "6": OrderTrace(QUEUED)}
    traces = trace_movement(traces, away(ARRIVES, 1.0))
    assert (traces["5"].arrived_at, traces["6"].arrived_at) == (1.0, None)
    assert trace_movement(traces, away(0.0, 1.0 + SEEN_AGAIN / 2)) is traces
    assert trace_movement(traces, away(0.0, 1.0 + SEEN_AGAIN))["5"].arrived_at == 1.0 + SEEN_AGAIN
    assert trace_movement(traces, away(ARRIVES + 0.1, 9.0)) is traces


@pytest.mark.parametrize("state", [state for state in OrderState if replace(QUEUED, state=state).is_over])
def test_every_listed_end_is_an_end(state: OrderState) -> None:
    gone = listed_end(replace(QUEUED, state=state), 3.0)
    assert gone.stage is not Stage.CONFIRMED and gone.reason == "as reported by the robot"


def test_an_id_that_was_used_before_means_its_later_end() -> None:
    early, late = (GoneOrder(QUEUED, at, Stage.DONE, EMPTY) for at in (1.0, 9.0))
    assert latest([early, late], "5", 5.0) is late
    assert latest([early, late], "5", 9.5) is None and latest([early], "6", 0.0) is None
