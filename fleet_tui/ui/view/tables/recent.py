"""The pane of the last events: current alarms, links that returned, commands given here, orders that began
or ended."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from heapq import nlargest
from operator import itemgetter

from fleet_tui.model.alarm import Alarm, AlarmStage
from fleet_tui.model.commands import ORDER_ENDS, CommandRecord, Stage
from fleet_tui.model.fleet import FleetState, returned_text
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.order import Order
from fleet_tui.model.order_life import GoneOrder
from fleet_tui.model.robot import Robot
from fleet_tui.orders.ends import ended_orders, placed_by, seen_end
from fleet_tui.situation.alarms.past import told
from fleet_tui.situation.batches import pauses, summary
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.commands import TROUBLE, command_text, stage_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.columns import Column, FittedColumns, rows_of
from fleet_tui.ui.view.tables.missions import destinations, mission, whose_mission
from fleet_tui.ui.view.tables.news import without_cause
from fleet_tui.ui.view.tables.table import Run, Table

Event = tuple[float, str, Callable[[], Run]]
"""Unix seconds, its robot or other source, and what happened: only the newest ones are written out."""

WHOLE = 60
HOURS_MINUTES = 5
"""Cells of a pane from which times have seconds, and those of a time without them."""


def recent_table(state: FleetState, clock: Callable[[float], str], lines: int, width: int = WHOLE) -> Table:
    """Return the newest events, in at most `lines` lines. `clock` formats Unix seconds as a local time, which
    has no seconds in a pane of few cells."""
    found = [*_alarms(state), *_links(state), *_commands(state), *_orders(state, width < WHOLE)]
    newest = nlargest(lines, found or _connected(state), key=itemgetter(0))
    shown = None if width >= WHOLE else HOURS_MINUTES
    columns: Sequence[Column[Event]] = (
        Column("", lambda event: (clock(event[0])[:shown], StyleRole.DIM), (1, 8)),
        Column("", lambda event: (event[1], StyleRole.DIM), (7, 15)),
        Column("", lambda event: event[2]()),
    )
    rows = rows_of(FittedColumns(columns, newest, width), newest, lambda _: None, whole=lambda _: True)
    return Table(((tr("Recent"), StyleRole.TITLE),), rows[:lines], tr("nothing yet"))


def _alarms(state: FleetState) -> Iterator[Event]:
    for alarm in state.alarms:
        at = alarm.shown_wall
        yield at, alarm.condition.source, partial(_alarm, alarm)


def _links(state: FleetState) -> Iterator[Event]:
    for link in state.links.values():
        if text := returned_text(state, link):
            yield _since(state, link), link.name, partial(_returned, text)


def _connected(state: FleetState) -> Iterator[Event]:
    for link in state.links.values():
        if link.phase is Phase.UP:
            yield _since(state, link), link.name, partial(_returned, Message("connected"))


def _since(state: FleetState, link: LinkState) -> float:
    return state.wall - (state.now - link.since)


def _returned(text: Message) -> Run:
    return translate(sanitize(text)), StyleRole.TEXT


def _alarm(alarm: Alarm) -> Run:
    is_quiet = not alarm.holds or alarm.stage is AlarmStage.SHELVED
    text = without_cause(alarm, told(alarm))  # the alarms pane has that of an order
    return translate(sanitize(text)), StyleRole.DIM if is_quiet else StyleRole.ALARM


def _commands(state: FleetState) -> Iterator[Event]:
    together = pauses(state.commands)
    for batch in together:
        yield batch[0].wall, tr("{batch} robots", batch=len(batch)), partial(_batch, state, batch)
    of_batches = {record.id for batch in together for record in batch}
    for record in state.commands:
        if record.id in of_batches:
            continue
        # Of an order that was in a queue its own line tells.
        gone = [one.order.id for one in state.robots[record.command.robot].gone]
        if record.stage not in ORDER_ENDS or record.order_id not in gone:
            yield record.wall, record.command.robot, partial(_command, state, record)


def _command(state: FleetState, record: CommandRecord) -> Run:
    text = command_text(state, record.command).removeprefix(f"{record.command.robot} ")
    return _said(f"{text}: {stage_text(record, state.now)}", record.stage)


def _batch(state: FleetState, batch: list[CommandRecord]) -> Run:
    name, outcome = summary(state, batch)
    worst = next((record.stage for record in batch if record.stage in TROUBLE), batch[0].stage)
    return _said(f"{translate(name)}: {translate(outcome)}", worst)


def _orders(state: FleetState, is_narrow: bool) -> Iterator[Event]:
    for robot in state.robots.values():
        for gone in ended_orders(state, robot):
            at = state.wall - (state.now - gone.at)
            if gone is not robot.gone[-1] or not _is_alarm(state, robot, gone):
                yield at, robot.name, partial(_order, state, robot, gone, is_narrow)
        for trace in robot.traces.values():
            record = placed_by(state, robot, trace.order)
            goes_on = record is not None and record.earlier_goals != ()
            if trace.began_at is not None and not goes_on:
                began = partial(_begun, state, robot, trace.order, is_narrow)
                yield state.wall - (state.now - trace.began_at), robot.name, began


def _is_alarm(state: FleetState, robot: Robot, gone: GoneOrder) -> bool:
    """Tell whether an alarm in the list tells the end of an order."""
    own = (one for one in state.commands if (one.command.robot, one.order_id) == (robot.name, gone.order.id))
    parts = {gone.order.id, *(f"{record.id} {record.stage.value}" for record in own)}
    keys = (robot.name, "command"), (robot.name, "order")
    alarms = (alarm for alarm in state.alarms if alarm.key in keys)
    return any(parts & alarm.condition.parts for alarm in alarms)


def _begun(state: FleetState, robot: Robot, order: Order, is_narrow: bool) -> Run:
    return _what(state, robot, order, tr("started"), is_narrow), StyleRole.DIM


def _order(state: FleetState, robot: Robot, gone: GoneOrder, is_narrow: bool) -> Run:
    stage = seen_end(state, robot, gone).stage
    return _said(_what(state, robot, gone.order, tr(stage.value), is_narrow), stage)


def _what(state: FleetState, robot: Robot, order: Order, happened: str, is_narrow: bool) -> str:
    """Return what happened to an order; in a narrow pane, where the end is cut, that is first."""
    if is_narrow:
        return f"{happened} {destinations(robot, order) or mission(robot, order)}"
    return f"{whose_mission(state, robot, order)}: {happened}"


def _said(text: str, stage: Stage) -> Run:
    return text, StyleRole.WARN if stage in TROUBLE else StyleRole.TEXT
