"""Order ends: inferred from queue and pose for an order that is no longer driven.

A robot of the source only shows that an order is gone. It counts as done unless there is evidence against it,
and as lost only if it may have ended unseen, or its robot has forgotten it: one rule, for the orders of this
console and for all others.
"""

import math
from collections.abc import Callable, Iterable, Mapping

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.commands import ORDER_ENDS, Stage
from fleet_tui.model.order import BEGUN, Order, OrderQueue, OrderState
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.units import age

ARRIVES = 2.0
"""Metres from its last vertex within which a robot must have been to count as having driven the order."""
SEEN_AGAIN = 0.5
"""Seconds at its end after which that is recorded again: poses arrive ten times a second."""
LEFT_WITHIN = 3.0
"""Seconds before a queue that still shows an order in which a visit to its end counts. Earlier visits had
another cause: many orders begin where they end, and fetch from elsewhere."""
BLIND_AFTER = 5.0
"""Seconds without a queue after which an order may have been driven unseen."""

NOT_LISTED = Message("no longer listed, end not reported: may have been completed")
STARTED_OVER = Message("the robot restarted: its order ids started over")

Away = Callable[[Order], tuple[float, float] | None]
"""Metres from the robot to an order's last stop, infinite on another floor, and the monotonic second of that
report; None if unknown."""


class OrderTrace(Struct, frozen=True):
    """An order in the queue: whether it was `begun`; `began_at` is when a queue first showed that, None if
    nobody saw it change; `arrived_at` is when the robot was last at its end since then, `listed_at` when a
    queue first listed it (all monotonic); `request_id` is the queue's echo while it was the newest, 0 for
    none."""

    order: Order
    begun: bool = False
    arrived_at: float | None = None
    request_id: int = 0
    began_at: float | None = None
    listed_at: float | None = None

    def was_driven(self, last_listed: float | None) -> bool:
        """Tell whether the robot was at its end when it left the queue; `last_listed`: when a queue last
        showed it."""
        return self.arrived_at is not None and (
            last_listed is None or self.arrived_at >= last_listed - LEFT_WITHIN
        )


class GoneOrder(Struct, frozen=True):
    """An order that left the queue, or is listed as ended, at a monotonic second: one of ORDER_ENDS, and the
    evidence. `is_reported`: the robot itself says so; `listed_at` as in OrderTrace."""

    order: Order
    at: float
    stage: Stage
    reason: Message
    is_reported: bool = False
    listed_at: float | None = None


def trace_movement(traces: Mapping[str, OrderTrace], away: Away) -> Mapping[str, OrderTrace]:
    """Record the time at which a robot was at the end of an order that it has begun."""
    arrived = {
        id_: replace(trace, arrived_at=seen[1])
        for id_, trace in traces.items()
        if trace.begun and (seen := away(trace.order)) is not None and _is_news(trace, *seen)
    }
    return {**traces, **arrived} if arrived else traces


def _is_news(trace: OrderTrace, metres: float, at: float) -> bool:
    last = trace.arrived_at
    return metres <= ARRIVES and (last is None or at - last >= SEEN_AGAIN)


def trace_queue(
    traces: Mapping[str, OrderTrace],
    queue: OrderQueue,
    at: float,
    before: tuple[float, int] | None,
    away: Away,
    reports_ends: bool = False,
) -> tuple[Mapping[str, OrderTrace], list[GoneOrder]]:
    """Compare a queue with the orders that were open before it; `before`: time of the last queue and its last
    serial; `reports_ends`: such a robot lists how an order ended.

    Returns the orders that are open now, and those that have ended.
    """
    listed = {order.id: order for order in queue.orders}
    last_listed = before[0] if before else None
    starts_over = before is not None and queue.last_serial < before[1]
    gone = [
        GoneOrder(trace.order, at, Stage.LOST, NOT_LISTED, listed_at=trace.listed_at)
        if reports_ends and id_ not in listed
        else replace(
            _end_of(trace, listed.get(id_), last_listed, at, starts_over, away), listed_at=trace.listed_at
        )
        for id_, trace in traces.items()
        if _is_over(trace, listed.get(id_))
    ]
    seen_at = at if last_listed is not None and at - last_listed < BLIND_AFTER else None
    still = {
        id_: _traced(traces.get(id_), order, queue, at, seen_at)
        for id_, order in listed.items()
        if not order.is_over
    }
    return trace_movement(still, away), gone


def _traced(
    before: OrderTrace | None, order: Order, queue: OrderQueue, at: float, seen_at: float | None
) -> OrderTrace:
    begun = order.state in BEGUN or queue.is_current(order)
    began_at = seen_at if begun else None
    if before is None or not _is_same(before.order, order):
        is_newest = order.serial == queue.last_serial
        request_id = queue.request_id if is_newest else 0
        return OrderTrace(order, begun, request_id=request_id, began_at=began_at, listed_at=at)
    if before.begun:
        return replace(before, order=order)
    return replace(before, order=order, begun=begun, began_at=began_at)


def _is_same(one: Order, other: Order) -> bool:
    return (one.id, one.serial, one.stops) == (other.id, other.serial, other.stops)


def _is_over(trace: OrderTrace, listed: Order | None) -> bool:
    return listed is None or listed.is_over or not _is_same(trace.order, listed)


def _end_of(
    trace: OrderTrace,
    listed: Order | None,
    last_listed: float | None,
    at: float,
    starts_over: bool,
    away: Away,
) -> GoneOrder:
    if listed is not None and listed.is_over and _is_same(trace.order, listed):
        return listed_end(listed, at)
    if listed is not None or starts_over:
        return GoneOrder(trace.order, at, Stage.LOST, STARTED_OVER)
    stage, reason = _unlisted_end(trace, last_listed, at, away)
    return GoneOrder(trace.order, at, stage, reason)


def _unlisted_end(
    trace: OrderTrace, last_listed: float | None, at: float, away: Away
) -> tuple[Stage, Message]:
    if trace.was_driven(last_listed):
        return Stage.DONE, Message("driven to the end")
    if last_listed is not None and at - last_listed > BLIND_AFTER:
        blind = Message("left the queue while no queue was received for {age}", age=age(at - last_listed))
        return Stage.LOST, Message("{blind}: may have been completed", blind=blind)
    if not trace.begun:
        return Stage.LEFT, Message("not by this console, before it started")
    seen = away(trace.order)
    if seen is None:
        return Stage.DONE, Message("left the queue after it started")
    metres, seen_at = seen
    if at - seen_at > BLIND_AFTER:
        blind = Message("left the queue while no pose was received for {age}", age=age(at - seen_at))
        return Stage.LOST, Message("{blind}: may have been completed", blind=blind)
    where = (
        Message("on another floor")
        if metres == math.inf
        else Message("{metres} m from its end", metres=f"{metres:.0f}")
    )
    return Stage.LEFT, Message("not by this console, with the robot {where}", where=where)


UNSAID = Message("as reported by the robot")
"""The reason of an end of which the robot said no more."""

_ENDS = {
    OrderState.DONE: Stage.DONE,
    OrderState.CANCELLED: Stage.CANCELLED,
    OrderState.LOST: Stage.LOST,
    OrderState.FAILED: Stage.FAILED,
    OrderState.REPLACED: Stage.REPLACED,
    OrderState.REFUSED: Stage.FAILED,
}


def listed_end(order: Order, at: float) -> GoneOrder:
    """Return the end of an order that the robot lists as over."""
    assert order.state is not None
    return GoneOrder(order, at, _ENDS[order.state], verbatim(order.said) or UNSAID, is_reported=True)


def corrected(gone: tuple[GoneOrder, ...], queue: OrderQueue, reports_ends: bool) -> tuple[GoneOrder, ...]:
    """Return the orders that left, those with an inferred end with the one that the robot lists now, and
    without those that it lists as open again: they have not ended."""
    listed = {order.id: order for order in queue.orders}
    known = list[GoneOrder]()
    for one in gone:
        if not _is_listed(one, listed, reports_ends):
            known.append(one)
        elif (order := listed[one.order.id]).is_over:
            known.append(replace(listed_end(order, one.at), listed_at=one.listed_at))
    return gone if known == [*gone] else tuple(known)


def _is_listed(gone: GoneOrder, listed: Mapping[str, Order], reports_ends: bool) -> bool:
    """Tell whether an order with an inferred end is among the `listed` ones, by id: the robot knows better.
    Where ends are reported an id is never used twice; a goal that is listed again has a new serial."""
    order = listed.get(gone.order.id)
    if order is None or not ORDER_ENDS[gone.stage].is_inferred or gone.reason == STARTED_OVER:
        return False
    return reports_ends or _is_same(gone.order, order)


def latest(gone: Iterable[GoneOrder], order_id: str, since: float) -> GoneOrder | None:
    """Find the end of an order at or after a monotonic second, None if it has not ended."""
    return next((one for one in gone if one.order.id == order_id and one.at >= since), None)
