"""The line that says where the last commands stand, in the words of the operator."""

from fleet_tui.model.commands import (
    FAILURES,
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    PlaceOrderWithCargo,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.fleet import FleetState, age
from fleet_tui.view.fleet_rows import place
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run
from fleet_tui.view.text import visible

# Commands given within this many seconds were meant as one; so many of them fit in a line.
TOGETHER, FEW = 0.3, 3
# Seconds for which a command that did not end well stays in view.
REMEMBERED = 30.0

TROUBLE = FAILURES | {Stage.NO_ANSWER, Stage.UNKNOWN}
_INKS = {Stage.CONFIRMED: Ink.GOOD, Stage.ACCEPTED: Ink.GOOD, Stage.TAKEN: Ink.GOOD}


def command_text(state: FleetState, command: Command) -> str:
    """A command in the words of the operator."""
    robot = state.robots[command.robot]
    match command:
        case PlaceOrder(name, start, end):
            return f"{name} order {place(robot, start)} -> {place(robot, end)}"
        case PlaceOrderWithCargo(name, end):
            return f"{name} bring cargo -> {place(robot, end)}"
        case CancelOrder(name, order_id):
            return f"{name} cancel order {order_id}"
        case ClearOrders(name):
            return f"{name} clear all orders"
        case PauseRobot(name):
            return f"{name} pause"
        case ResumeRobot(name):
            return f"{name} resume"


def stage_text(record: CommandRecord, now: float) -> str:
    """Where a command stands, as it is written everywhere."""
    if record.stage in (Stage.SENT, Stage.ACCEPTED):
        return f"{record.stage.value} {age(now - record.at)} ago"
    return "sending" if record.stage is Stage.CHECKED else str(record.stage.value)


def _group_runs(state: FleetState, records: list[CommandRecord]) -> tuple[Run, ...]:
    """Commands of one kind at one stage, as one: pause all of a large fleet is one line."""
    first = records[0]
    text = command_text(state, first.command)
    if len(records) > 1:
        text += f" and {len(records) - 1} more like it"
    ink = Ink.ALARM if first.stage in TROUBLE else _INKS.get(first.stage, Ink.DIM)
    # What a robot says on accepting ("paused") is true for that moment only.
    words = "" if first.stage is Stage.ACCEPTED or not first.words else f" ({visible(first.words)})"
    return (text, Ink.TEXT), (f": {stage_text(first, state.now)}", ink), (words, Ink.DIM)


def _worth_saying(state: FleetState) -> list[CommandRecord]:
    """What was given last, what is under way, and what went wrong a short while ago."""
    last = state.commands[-1]
    return [
        record
        for record in state.commands
        if last.issued_at - record.issued_at < TOGETHER
        or not record.ended
        or (record.stage in TROUBLE and state.now - record.at < REMEMBERED)
    ]


def message_line(state: FleetState, said: str, said_at: float) -> tuple[Run, ...]:
    """The newest word to the operator: what the console says, how the last commands stand."""
    groups: dict[object, list[CommandRecord]] = {}
    # What went wrong comes first, the newest before the others: it must not be cut at the right end.
    records = sorted(
        _worth_saying(state) if state.commands else [],
        key=lambda record: (record.stage not in TROUBLE, -record.issued_at),
    )
    for record in records:
        group = (type(record.command), record.stage, record.words)
        groups.setdefault(group if len(records) > FEW else record.id, []).append(record)
    runs: list[Run] = [(f" {said}", Ink.WARN)] if said and _is_news(state, said_at) else []
    for together in groups.values():
        runs += [(" " if not runs else "   ", Ink.TEXT), *_group_runs(state, together)]
    return tuple(runs)


def _is_news(state: FleetState, said_at: float) -> bool:
    """The console's own word stands until the next command."""
    return not state.commands or said_at > state.commands[-1].issued_at
