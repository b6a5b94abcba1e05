"""Orders in progress, from the queue to their end."""

from collections.abc import Callable
from dataclasses import replace

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE, Outcome
from fleet_tui.cli.session import WaitingStore
from fleet_tui.model.commands import CommandRecord, Stage
from fleet_tui.model.fleet import FleetState


def follow_order(
    latest: Callable[[], CommandRecord], queued: Outcome, store: WaitingStore, seconds: float
) -> Outcome:
    """Wait at most `seconds` for the end of an order that was `queued`. `latest` returns the newest record of
    the command that placed it."""
    if latest().order_id is None:
        return queued
    store.wait(lambda state: _is_over(latest()) or _is_stuck(state, latest()), seconds)
    record = latest()
    if not _is_over(record):
        return replace(queued, outcome="not done", words=_where(store.state, record), code=NOT_DONE)
    done = record.stage is Stage.DONE
    return replace(
        queued,
        outcome="done" if done else "not done",
        words=record.detail if done else f"{record.stage.value}: {record.detail}",
        code=DONE if done else NOT_DONE,
        seconds=round(record.at - record.issued_at, 3),
    )


def _is_over(record: CommandRecord) -> bool:
    """Tell whether an order is over: its next stop may have been refused, too."""
    return record.is_decided and not record.has_open_order


def _is_stuck(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether its next stop is held: the queue of this command has no operator to resume it."""
    return record.stage is Stage.WAITING and bool(state.robots[record.command.robot].held)


def _where(state: FleetState, record: CommandRecord) -> str:
    robot = state.robots[record.command.robot]
    if record.stage is Stage.WAITING:
        words = f"order {record.order_id} waiting here"
    else:
        listed = (order.state_text for order in robot.orders.orders if order.id == record.order_id)
        words = f"order {record.order_id} is {next(listed, '') or 'in the queue'}"
    words += f": {robot.held}" if robot.held else ", not done within the time limit"
    is_left = record.stage is Stage.WAITING or record.has_further_leg(robot.kind)
    return words + "; its remaining stops are not sent" * is_left
