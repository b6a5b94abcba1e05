"""The line that is always in view: the link, the alarms, the selected robot."""

from collections.abc import Iterator, Sequence

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    CommandRecord,
    Outcome,
    PauseRobot,
    PlaceOrder,
    PlaceOrderWithCargo,
    ResumeRobot,
)
from fleet_tui.model.fleet import FleetState, age
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.view.fleet_rows import place
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run
from fleet_tui.view.text import visible

# Commands given within this many seconds were meant as one; so many of them fit in a line.
TOGETHER, FEW = 0.3, 3
# Seconds for which a command that did not end well stays in view.
REMEMBERED = 30.0

# A link on which something came within so many seconds is well.
SILENT_AFTER = 2.0
# The writer tells the time ten times a second. Where it doesn't, ages stand still and all looks live.
BLIND_AFTER = 2.0


def console_notes(read_only: bool, armed: bool, standstill: float) -> list[str]:
    """What holds for this console, and that it has gone blind: the state is `standstill` seconds old."""
    notes = {
        "read-only": read_only,
        "not armed": not armed,
        f"nothing is updated for {age(standstill)}: restart this console": standstill > BLIND_AFTER,
    }
    return [note for note, holds in notes.items() if holds]


def _link_runs(link: LinkState, now: float) -> Iterator[Run]:
    if link.phase is not Phase.UP:
        yield "○ no link ", Ink.ALARM
        yield f"{visible(link.url)} ", Ink.TEXT
        if link.reason:
            yield f"{visible(link.reason)}, ", Ink.WARN
        if link.phase is Phase.CONNECTING or link.next_try is None:
            yield "trying now", Ink.TEXT
        else:
            yield f"next try {max(0.0, link.next_try - now):.0f} s", Ink.TEXT
        heard = "" if link.heard is None else f", last message {age(now - link.heard)} ago"
        yield f", since {age(now - link.since)}{heard}", Ink.DIM
        return
    yield "● ", Ink.GOOD
    yield f"{visible(link.url)} ", Ink.TEXT
    if link.heard is None:
        yield "nothing heard yet", Ink.DIM
    else:
        silent = max(0.0, now - link.heard)
        yield f"{silent:.1f} s", Ink.DIM if silent < SILENT_AFTER else Ink.WARN
    if link.command_path is CommandPath.DEAD:
        yield f" commands dead: {visible(link.command_reason)}", Ink.ALARM
    if link.faults:
        yield f" {link.faults} bad frames", Ink.WARN


def _worst(state: FleetState) -> LinkState:
    """The link that needs a person most; all of them in the order of the config."""
    return min(
        state.links.values(),
        key=lambda link: (
            link.phase is Phase.UP,
            link.command_path is not CommandPath.DEAD,
            link.heard or 0.0,
        ),
    )


def status_line(state: FleetState, selected: str, notes: Sequence[str] = ()) -> tuple[Run, ...]:
    """What stands first is what must not be cut: alarms, the selected robot, the link."""
    fresh, alarms = state.unacknowledged, len(state.alarms)
    runs: list[Run] = [(f" {visible(selected)}  ", Ink.ACCENT)]
    sign, ink = ("▲", Ink.ALARM) if fresh else ("△", Ink.TEXT if alarms else Ink.DIM)
    runs.append((f"{sign} {alarms} alarm{'s' * (alarms != 1)}" + (f" ({fresh} new)" if fresh else ""), ink))
    runs.append(("  ", Ink.TEXT))
    runs.extend((note + "  ", Ink.WARN) for note in notes)
    others = len(state.links) - 1
    runs.extend(_link_runs(_worst(state), state.now))
    if others > 0:
        up = sum(link.phase is Phase.UP for link in state.links.values())
        runs.append((f"  {up} of {others + 1} links up", Ink.DIM))
    return tuple(runs)


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


def _group_runs(state: FleetState, records: list[CommandRecord]) -> tuple[Run, ...]:
    """Commands of one kind with one end, as one: pause all of a large fleet is one line."""
    first = records[0]
    text = command_text(state, first.command)
    if len(records) > 1:
        text += f" and {len(records) - 1} more like it"
    if first.outcome is None:
        return (text, Ink.TEXT), (f": sent {age(state.now - first.issued_at)} ago", Ink.DIM)
    ink = Ink.GOOD if first.outcome is Outcome.ACCEPTED else Ink.ALARM
    # What a robot says on accepting ("paused") is true for that moment only.
    words = "" if first.outcome is Outcome.ACCEPTED or not first.words else f" ({visible(first.words)})"
    return (text, Ink.TEXT), (f": {first.outcome.value}", ink), (words, Ink.DIM)


def status_right(clock: str) -> tuple[Run, ...]:
    """What fills the right end where there is room."""
    return (("fleet-tui  ", Ink.DIM), (f"{clock} ", Ink.DIM))


def _worth_saying(state: FleetState) -> list[CommandRecord]:
    """What was given last, and what ended badly a short while ago, whatever was given since."""
    last = state.commands[-1]
    return [
        record
        for record in state.commands
        if last.issued_at - record.issued_at < TOGETHER
        or (
            record.outcome not in (Outcome.ACCEPTED, None)
            and record.ended_at is not None
            and state.now - record.ended_at < REMEMBERED
        )
    ]


def message_line(state: FleetState, said: str, said_at: float) -> tuple[Run, ...]:
    """The newest word to the operator: what the console says, how the last commands stand."""
    groups: dict[object, list[CommandRecord]] = {}
    # What went wrong comes first, the newest before the others: it must not be cut at the right end.
    records = sorted(
        _worth_saying(state) if state.commands else [],
        key=lambda record: (record.outcome in (Outcome.ACCEPTED, None), -record.issued_at),
    )
    for record in records:
        group = (type(record.command), record.outcome, record.words)
        groups.setdefault(group if len(records) > FEW else record.id, []).append(record)
    runs: list[Run] = [(f" {said}", Ink.WARN)] if said and _is_news(state, said_at) else []
    for together in groups.values():
        runs += [(" " if not runs else "   ", Ink.TEXT), *_group_runs(state, together)]
    return tuple(runs)


def _is_news(state: FleetState, said_at: float) -> bool:
    """The console's own word stands until the next command."""
    return not state.commands or said_at > state.commands[-1].issued_at
