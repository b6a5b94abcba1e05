"""Orders on their way, from the queue until they were driven."""

from collections.abc import Callable
from dataclasses import replace

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE, Outcome
from fleet_tui.cli.session import WaitingStore
from fleet_tui.model.commands import ORDER_ENDS, CommandRecord, Stage


def follow_order(
    latest: Callable[[], CommandRecord], queued: Outcome, store: WaitingStore, seconds: float
) -> Outcome:
    """Wait until an order that was `queued` was driven, or was not; `seconds` at most. `latest` gives the
    newest record of the command that placed it."""
    if latest().order_id is None:
        return queued
    store.wait(lambda _: latest().stage in ORDER_ENDS, seconds)
    record = latest()
    if record.stage not in ORDER_ENDS:
        listed = store.state.robots[record.command.robot].orders.orders
        state = next((order.state_text for order in listed if order.id == record.order_id), "")
        words = f"order {record.order_id} is {state or 'in the queue'}"
        words += ", and was not driven yet when the time was up"
        if record.has_further_leg(store.state.robots[record.command.robot].kind):
            words += "; its other stops are not given"
        return replace(queued, outcome="not done", words=words, code=NOT_DONE)
    done = record.stage is Stage.DONE
    return replace(
        queued,
        outcome="done" if done else "not done",
        words=record.words if done else f"{record.stage.value}: {record.words}",
        code=DONE if done else NOT_DONE,
        seconds=round(record.at - record.issued_at, 3),
    )
