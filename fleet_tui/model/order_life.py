"""Order ends: what the queue and the pose show of an order that is no longer driven.

A robot of the source only shows that an order is gone. It was done unless something speaks against it:
one rule, for the orders of this console and for all others.
"""

from collections.abc import Callable, Iterable, Mapping

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.commands import Stage
from fleet_tui.model.order import Order, OrderQueue

ARRIVES = 2.0
"""Metres from its last vertex within which a robot was, if it drove the order and did not just lose it."""
NEARER = 0.5
"""Metres by which a robot must have come nearer for that to be kept: poses come ten times a second."""
BLIND_AFTER = 5.0
"""Seconds without a queue after which an order may have been driven unseen."""

STARTED_OVER = "the robot's order ids started over"

Away = Callable[[Order], float | None]
"""Metres from the robot to an order's last vertex: infinite on another floor, None where unknown."""


class OrderTrace(Struct, frozen=True):
    """An order in the queue: whether it was `begun`, and since then how near the robot came to its end;
    `nearest` in metres, None where that is unknown."""

    order: Order
    begun: bool = False
    nearest: float | None = None


class GoneOrder(Struct, frozen=True):
    """An order that left the queue, or is listed as ended, at a monotonic second: DONE, CANCELLED or LOST,
    and what showed it."""

    order: Order
    at: float
    stage: Stage
    reason: str


def trace_movement(traces: Mapping[int, OrderTrace], current: int, away: Away) -> Mapping[int, OrderTrace]:
    """Keep how near a robot came to the end of the order that it drives."""
    trace = traces.get(current)
    if trace is None or not trace.begun or (trace.nearest is not None and trace.nearest <= ARRIVES):
        return traces
    metres = away(trace.order)
    if metres is None:
        return traces
    if trace.nearest is not None and ARRIVES < metres > trace.nearest - NEARER:
        return traces
    return {**traces, current: replace(trace, nearest=metres)}


def trace_queue(
    traces: Mapping[int, OrderTrace], queue: OrderQueue, at: float, heard: float | None, away: Away
) -> tuple[Mapping[int, OrderTrace], list[GoneOrder]]:
    """Compare a queue with the orders that were open before it; `heard` is when the queue came last.

    Returns the orders that are open now, and those that have ended.
    """
    listed = {order.id: order for order in queue.orders}
    gone = [
        _end_of(trace, listed.get(id_), queue, at, heard)
        for id_, trace in traces.items()
        if _is_over(trace, listed.get(id_))
    ]
    still = {
        id_: _traced(traces.get(id_), order, queue) for id_, order in listed.items() if not order.is_over
    }
    return trace_movement(still, queue.current_order_id, away), gone


def _traced(before: OrderTrace | None, order: Order, queue: OrderQueue) -> OrderTrace:
    begun = order.status == "W" or order.id == queue.current_order_id
    if before is None or not _is_same(before.order, order):
        return OrderTrace(order, begun)
    return replace(before, order=order, begun=before.begun or begun)


def _is_same(one: Order, other: Order) -> bool:
    return (one.id, one.start, one.end) == (other.id, other.start, other.end)


def _is_over(trace: OrderTrace, listed: Order | None) -> bool:
    return listed is None or listed.is_over or not _is_same(trace.order, listed)


def _end_of(
    trace: OrderTrace, listed: Order | None, queue: OrderQueue, at: float, heard: float | None
) -> GoneOrder:
    order = trace.order

    def gone(stage: Stage, reason: str) -> GoneOrder:
        return GoneOrder(order, at, stage, reason)

    if listed is not None and not _is_same(order, listed):
        return gone(Stage.LOST, STARTED_OVER)
    if listed is not None:
        return gone(Stage.CANCELLED if listed.status == "C" else Stage.DONE, "as the robot reports")
    if queue.last_order_id < order.id:
        return gone(Stage.LOST, STARTED_OVER)
    if trace.nearest is not None and trace.nearest <= ARRIVES:
        return gone(Stage.DONE, "driven to its end")
    if heard is not None and at - heard > BLIND_AFTER:
        blind = f"it left the queue while none came for {at - heard:.0f} s"
        return gone(Stage.LOST, f"{blind}: it may have been driven")
    if not trace.begun:
        return gone(Stage.LOST, "it left the queue before it was begun")
    if trace.nearest is not None:
        metres = (
            "on another floor" if trace.nearest == float("inf") else f"{trace.nearest:.0f} m from its end"
        )
        return gone(Stage.LOST, f"it left the queue with the robot {metres}")
    return gone(Stage.DONE, "left the queue after it was begun")


def latest(gone: Iterable[GoneOrder], order_id: int, since: float) -> GoneOrder | None:
    """Find how an order ended at or after a monotonic second, None while it has not."""
    return next((one for one in gone if one.order.id == order_id and one.at >= since), None)
