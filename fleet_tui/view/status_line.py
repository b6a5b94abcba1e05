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

# Commands given within this many seconds were meant as one.
TOGETHER = 0.3

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
        yield f", since {age(now - link.since)}", Ink.DIM
        return
    yield "● ", Ink.GOOD
    yield f"{visible(link.url)} ", Ink.TEXT
    yield ("nothing heard yet" if link.heard is None else f"{max(0.0, now - link.heard):.1f} s"), Ink.DIM
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


def command_runs(state: FleetState, record: CommandRecord) -> tuple[Run, ...]:
    """One command and where it stands."""
    text = command_text(state, record.command)
    if record.outcome is None:
        return (text, Ink.TEXT), (f": sent {age(state.now - record.issued_at)} ago", Ink.DIM)
    ink = Ink.GOOD if record.outcome is Outcome.ACCEPTED else Ink.ALARM
    said = visible(record.words)
    words = f" ({said})" if said.casefold() not in ("", record.outcome.value) else ""
    return (text, Ink.TEXT), (f": {record.outcome.value}", ink), (words, Ink.DIM)


def status_right(clock: str) -> tuple[Run, ...]:
    """What fills the right end where there is room."""
    return (("fleet-tui  ", Ink.DIM), (f"{clock} ", Ink.DIM))


def message_line(state: FleetState, said: str, said_at: float) -> tuple[Run, ...]:
    """The newest word to the operator: what the console says, else how the last commands stand.

    Commands given together, as by pause all, stand together.
    """
    last = state.commands[-1] if state.commands else None
    if said and (last is None or said_at > last.issued_at):
        return ((f" {said}", Ink.WARN),)
    if last is None:
        return ()
    together = [record for record in state.commands[-20:] if last.issued_at - record.issued_at < TOGETHER]
    # What went wrong must not be cut off at the right end.
    together.sort(key=lambda record: record.outcome in (Outcome.ACCEPTED, None))
    runs: list[Run] = []
    for record in together:
        runs += [(" " if not runs else "   ", Ink.TEXT), *command_runs(state, record)]
    return tuple(runs)
