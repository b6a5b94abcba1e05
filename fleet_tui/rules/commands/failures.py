"""Commands that failed, as conditions of the alarm list.

A failure is a moment and does not hold: it counts as news for a while, then its alarm has
returned, and stays until somebody acknowledges it.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import assert_never

from fleet_tui.model.alarm import Condition, Key, Priority
from fleet_tui.model.commands import (
    FAILURES,
    ORDER_ENDS,
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import route_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.batches import batches

FAILED_FOR = 30.0
"""Seconds for which a command that failed counts as news."""
_OVER = {stage: f"was {stage.value}" for stage in FAILURES & (ORDER_ENDS | {Stage.LATE}) - {Stage.FAILED}}
MANY = 5
"""Failed commands to so many robots that were given together are one alarm."""


def has_failed(record: CommandRecord) -> bool:
    """Tell whether a command that left this console needs a person: it failed, or went on unexpectedly."""
    return record.stage in FAILURES and record.stage is not Stage.NOT_SENT


def _wish(robot: Robot, command: Command) -> str:
    match command:
        case PlaceOrder(_, stops):
            return command.text(robot.kind, route_text(stops, lambda vertex: robot.name_of(vertex) or vertex))
        case CancelOrder(_, order_id):
            return f"cancel order {order_id}"
        case ClearOrders():
            return "clear all orders"
        case PauseRobot():
            return "pause"
        case ResumeRobot():
            return "resume"
        case _:
            assert_never(command)


def failed_commands(state: FleetState) -> Iterator[Condition]:
    """Commands that failed a short while ago: an alarm for each robot, or for each link where one
    wish for many robots failed."""
    fresh = [record for record in state.commands if has_failed(record) and state.now - record.at < FAILED_FOR]
    if not fresh:
        return
    given = {record.id: len(batch) for batch in batches(state.commands) for record in batch}
    failed: dict[Key, list[CommandRecord]] = defaultdict(list)
    for record in fresh:
        robot = state.robots.get(record.command.robot)
        if robot is not None:
            many = given[record.id] >= MANY
            failed[(robot.link, "many commands") if many else (robot.name, "command")].append(record)
    for key, records in failed.items():
        yield _failed(state, key, records)


def _failed(state: FleetState, key: Key, records: Sequence[CommandRecord]) -> Condition:
    last = records[-1]
    wish = _wish(state.robots[last.command.robot], last.command)
    robots = len({record.command.robot for record in records})
    if robots > 1:
        wish += f" of {robots} robots"
    high = any(isinstance(record.command, PauseRobot) for record in records)
    return Condition(
        *key,
        Priority.HIGH if high else Priority.MEDIUM,
        # How it failed comes first: it must not be cut at the right end.
        f"{last.stage.value}: {wish}" + (f" ({last.words})" if last.words else ""),
        f"{_OVER.get(last.stage, 'failed')}: {wish}",
        # A failure that turns into another one is news.
        parts=frozenset(f"{record.id} {record.stage.value}" for record in records),
    )
