"""Any frames through an adapter and the reducer, as robots of both navigation stacks may send them."""

from collections.abc import Iterable

import msgspec

from fleet_tui.model.events import Event, MessageRejected
from fleet_tui.model.fleet import FleetState
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros.operations import Publish, decode
from fleet_tui.state.reducer import apply
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import message_of
from tests.support.fleets import R0, T0, tick


def facts(adapter: Adapter, feed: Feed, message: object, at: float) -> list[Event]:
    """The events that the link makes from a message, or its rejection."""
    try:
        operation = decode(msgspec.json.encode({"op": "publish", "topic": feed.address, "msg": message}))
        assert isinstance(operation, Publish)
        return list(adapter.read(feed, operation.msg, at))
    except WireError as problem:
        return [MessageRejected(R0, message_of(problem))]


def assert_each_order_once(
    adapter: Adapter, state: FleetState, frames: Iterable[tuple[Feed, object] | None]
) -> None:
    """Apply the frames, None for a tick between two, and find no order twice in the queue."""
    at = T0
    for frame in frames:
        at += 0.3
        for fact in facts(adapter, *frame, at) if frame else [tick(at)]:
            state = apply(state, fact)
    for later in (0.1, 2.0, 9.0):
        state = apply(state, tick(at + later))
    ids = [order.id for order in state.robots[R0].orders.orders]
    assert len(ids) == len(set(ids))
