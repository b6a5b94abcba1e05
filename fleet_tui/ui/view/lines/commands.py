"""The line with the state of the last commands, in operator terms."""

import math
from collections.abc import Iterator, Sequence
from typing import assert_never

from fleet_tui.commands.rivals import rivals_text
from fleet_tui.model import commands
from fleet_tui.model.fleet import FleetState, returned_text
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.situation.batches import TOGETHER, pauses, summary
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.missions import way
from fleet_tui.ui.view.tables.table import Run, cut, width_of

# Number of commands that fit in a line one by one.
FEW = 3
# Seconds for which a failed command, and the return of a link, is shown.
REMEMBERED = 30.0
# Seconds after a failure in which a key may have been pressed without it having been read.
READ_AFTER = 1.0
# Seconds for which the success of the last command is shown.
SUCCEEDED = 10.0
# Seconds for which the successful end of an order is shown.
ENDED_WELL = 5.0

TROUBLE = commands.FAILURES | {commands.Stage.NO_ANSWER, commands.Stage.UNKNOWN}
_ROLES = dict.fromkeys(
    (
        commands.Stage.CONFIRMED,
        commands.Stage.ACCEPTED,
        commands.Stage.UNVERIFIABLE,
        commands.Stage.DONE,
        commands.Stage.CANCELLED,
    ),
    StyleRole.GOOD,
)


def command_text(state: FleetState, command: commands.Command) -> str:
    """Return the text of a command in operator terms."""
    robot = state.robots[command.robot]
    match command:
        case commands.PlaceOrder(name, stops):
            return f"{name} {translate(command.text(robot.kind, way(robot, stops)))}"
        case commands.CancelOrder(name, order_id):
            return tr("{name} cancel order {order_id}", name=name, order_id=sanitize(order_id))
        case commands.ClearOrders(name):
            return tr("{name} clear all orders", name=name)
        case commands.PauseRobot(name):
            return tr("{name} pause", name=name)
        case commands.ResumeRobot(name):
            return tr("{name} resume", name=name)
        case SetUpCommand(name):
            return f"{name} {translate(command.text)}"
        case _:
            assert_never(command)


def stage_text(record: commands.CommandRecord, now: float) -> str:
    """Return the text of a command's stage, the same everywhere."""
    if record.stage in (commands.Stage.SENT, commands.Stage.ACCEPTED):
        return f"{tr(record.stage.value)} {tr('{age} ago', age=age(now - record.at))}"
    return tr("sending") if record.stage is commands.Stage.CHECKED else tr(record.stage.value)


def _group_runs(
    state: FleetState, records: list[commands.CommandRecord], brief: bool = False
) -> tuple[Run, ...]:
    """Group commands of one kind at one stage: pause all of a large fleet is one line."""
    first = records[0]
    text = command_text(state, first.command)
    if brief and isinstance(first.command, commands.PlaceOrder):
        text = tr("{robot} order", robot=first.command.robot)
    if len(records) > 1:
        text += tr(" +{count} more", count=len(records) - 1)
    role = StyleRole.ALARM if first.stage in TROUBLE else _ROLES.get(first.stage, StyleRole.DIM)
    # A robot's answer on accepting ("paused") is true only at that moment.
    detail = "" if first.stage is commands.Stage.ACCEPTED else translate(detail_text(sanitize(first.detail)))
    runs = (text, StyleRole.TEXT), (f": {stage_text(first, state.now)}", role), (detail, StyleRole.DIM)
    others = sanitize(rivals_text(state, first.command.robot))
    return (
        (*runs, (tr(", also commanded by {others}", others=translate(others)), StyleRole.ACCENT))
        if others
        else runs
    )


def _worth_saying(state: FleetState, said_at: float, key_at: float) -> list[commands.CommandRecord]:
    """Return the open commands, those that failed a short while ago and were not followed by a key, and the
    last one until a while after its success or until something newer was said."""
    return [
        record
        for record in state.commands
        if state.now - record.at < _shown_for(state, record, said_at)
        and not (record.stage in commands.FAILURES and key_at > record.at + READ_AFTER)
    ]


def _shown_for(state: FleetState, record: commands.CommandRecord, said_at: float) -> float:
    """Return the seconds for which a command is shown at its stage."""
    # Orders kept by this console are in the queue pane.
    if not (record.is_decided or record.stage is commands.Stage.WAITING):
        return math.inf
    if record.stage in TROUBLE:
        return REMEMBERED
    if record.at >= said_at and state.commands[-1].issued_at - record.issued_at < TOGETHER:
        return SUCCEEDED
    return ENDED_WELL if record.stage in (commands.Stage.DONE, commands.Stage.CANCELLED) else 0.0


Part = tuple[Run, ...]


def _parts(state: FleetState, said_at: float, key_at: float) -> Iterator[tuple[bool, float, Part, Part]]:
    """Return the parts of the line: success, time, full text and short text of each."""
    worth = {record.id: record for record in _worth_saying(state, said_at, key_at)}
    for batch in pauses(state.commands):
        if any(record.id in worth for record in batch):
            for record in batch:
                worth.pop(record.id, None)
            part = _batch_runs(state, batch)
            yield not _is_trouble(batch), batch[-1].issued_at, part, part
    groups: dict[object, list[commands.CommandRecord]] = {}
    for record in sorted(worth.values(), key=lambda record: -record.issued_at):
        group = (type(record.command), record.stage, record.detail)
        groups.setdefault(group if len(worth) > FEW else record.id, []).append(record)
    for together in groups.values():
        brief = _group_runs(state, together, brief=True)[:2]
        yield not _is_trouble(together), together[0].issued_at, _group_runs(state, together), brief


def _is_trouble(records: Sequence[commands.CommandRecord]) -> bool:
    return any(record.stage in TROUBLE for record in records)


def _batch_runs(state: FleetState, batch: Sequence[commands.CommandRecord]) -> Part:
    what, detail = summary(state, batch)
    if _is_trouble(batch):
        role = StyleRole.ALARM
    else:
        role = StyleRole.GOOD if all(record.is_decided for record in batch) else StyleRole.DIM
    return (translate(what), StyleRole.TEXT), (f": {translate(detail)}", role)


def message_line(
    state: FleetState,
    said: Message,
    said_at: float,
    width: int,
    key_at: float = -math.inf,
    is_hint: bool = False,
) -> Part:
    """Return the newest message to the operator: the console's notice, the state of the last commands. `said`
    is empty once it is over, `said_at` remains; `key_at` is the time of the last key; `is_hint`: the notice
    only helps."""
    # Failures first, the newest leading: they must not be cut at the right end.
    found = sorted(_parts(state, said_at, key_at), key=lambda part: (part[0], -part[1]))
    parts, briefs = [part[2] for part in found], [part[3] for part in found]
    for returned in _returned(state):
        parts.append(returned)
        briefs.append(returned)
    if said and _is_news(state, said_at):
        notice = ((translate(said), StyleRole.DIM if is_hint else StyleRole.WARN),)
        parts.insert(0, notice)
        briefs.insert(0, notice)
    runs = _in_line(parts)
    return runs if width_of(runs) <= width else _squeezed(parts, briefs, width)


def _returned(state: FleetState) -> Iterator[Part]:
    """Yield the links that returned a short while ago: their alarms may have gone unseen."""
    for link in state.links.values():
        text = returned_text(state, link)
        if text and state.now - link.since < REMEMBERED:
            yield ((translate(sanitize(text)), StyleRole.TEXT),)


def _in_line(parts: list[tuple[Run, ...]]) -> tuple[Run, ...]:
    gaps = [" ", *["   "] * len(parts)]
    return tuple(
        run for gap, part in zip(gaps, parts, strict=False) for run in ((gap, StyleRole.TEXT), *part)
    )


def _squeezed(parts: list[tuple[Run, ...]], briefs: list[tuple[Run, ...]], width: int) -> tuple[Run, ...]:
    """Shorten the first parts to the width; stages are never cut: successful ones at the end are dropped
    before."""
    first, rest = parts[0], briefs[1:]
    while rest and width_of(_in_line([briefs[0], *rest])) > width:
        rest.pop()
    space = width - width_of(_in_line([(), *rest]))
    if width_of(first[:2]) > space:
        first = (*briefs[0], *first[2:])
    return _in_line([cut(first, space) if width_of(first) > space else first, *rest])


def _is_news(state: FleetState, said_at: float) -> bool:
    """Tell whether the console's notice is newer than the last command."""
    return not state.commands or said_at >= state.commands[-1].issued_at


def newest(state: FleetState) -> float:
    """Return the time of the newest information: a command may have been given since the last tick."""
    return max([state.now, *(record.issued_at for record in state.commands[-1:])])
