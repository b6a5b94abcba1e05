"""The alarm pane: conditions that need a person, and unacknowledged alarms."""

from collections.abc import Callable, Hashable, Iterator, Mapping
from operator import attrgetter
from textwrap import wrap
from typing import Any

from fleet_tui.model.alarm import Alarm, AlarmStage, Key, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.floods import is_group
from fleet_tui.situation.alarms.trouble import to_look_at, urgency
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import cell_width, sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column, FittedColumns, rows_of
from fleet_tui.ui.view.tables.short_names import own_names
from fleet_tui.ui.view.tables.table import INDENT, LEAST, Row, Run, Table

SIGNS = {
    AlarmStage.UNACKNOWLEDGED: Message("▲ new"),
    AlarmStage.RETURNED: Message("▽ over"),
    AlarmStage.ACKNOWLEDGED: Message("△ seen"),
    AlarmStage.SHELVED: Message("◇ shelved"),
}
PRIORITIES = {
    Priority.HIGH: Message("high"),
    Priority.MEDIUM: Message("medium"),
    Priority.LOW: Message("low"),
}
SHORT_PRIORITIES = {
    Priority.HIGH: Message("high"),
    Priority.MEDIUM: Message("med "),
    Priority.LOW: Message("low "),
}


WITH_PRIORITY = 44
"""Cells of a pane from which alarms have words for stage and priority, seconds, and robots long names."""
HOURS_MINUTES = 5
SHORT = 4
"""Cells of a priority in a narrow pane."""
FEW = 4
"""Alarms up to which one of them has its advice in view."""


def _role(alarm: Alarm) -> StyleRole:
    if not alarm.holds:
        return StyleRole.DIM
    if alarm.stage is AlarmStage.UNACKNOWLEDGED:
        return StyleRole.WARN if alarm.condition.priority is Priority.LOW else StyleRole.ALARM
    return StyleRole.TEXT if alarm.stage is AlarmStage.ACKNOWLEDGED else StyleRole.DIM


def _told(alarm: Alarm, clock: Callable[[float], str], cells: int, is_whole: bool) -> list[Run]:
    """Return the text of an alarm in so many cells, unless it is whole, and since when it holds if there is
    space for that."""
    text = translate(sanitize(alarm.text))
    if not is_whole and text.endswith(")") and cell_width(text) > cells:
        text = text.rpartition(" (")[0]
    since, count = f" {clock(alarm.shown_wall)}", f" x{alarm.count}" if alarm.count > 1 else ""
    if cell_width(text + since + count) > cells:
        since = ""  # half a time is none
    return [(text, _role(alarm)), (since + count, StyleRole.DIM)]


def _names(state: FleetState, most: int) -> Mapping[str, str]:
    """Return the name of each source: if one is too long, those of fleets have the robot's own part alone
    where it tells the robots apart."""
    names = {alarm.condition.source: alarm.condition.source for alarm in state.alarms}
    if max(map(cell_width, names), default=0) > most:
        own = own_names(tuple(state.robots))
        names |= {one: own[one] for one in names if one in own}
    return names


def _signs(alarm: Alarm, shelf: str, stages: int) -> list[Run]:
    """Return stage and priority, the stage in so many cells, of a narrow pane as a sign: what is most urgent
    as a chip, like a robot's on the map."""
    sign, priority = translate(SIGNS[alarm.stage]), alarm.condition.priority
    text = f"{sign[0]} {translate(SHORT_PRIORITIES[priority])[:SHORT]}{shelf}"
    if stages > 1:
        text = f"{sign:<{stages}}{shelf} {translate(PRIORITIES[priority])}"
    if alarm.needs_acknowledgement and alarm.holds and alarm.condition.priority is Priority.HIGH:
        return [(text.rstrip(), StyleRole.ROBOT_ALARM), ("", StyleRole.TEXT)]
    is_known = alarm.holds and alarm.stage is AlarmStage.ACKNOWLEDGED
    return [(text, StyleRole.WARN if is_known else _role(alarm))]


def _longest(words: Mapping[Any, Message]) -> int:
    """Return the cells of the longest word but that of shelved alarms."""
    return max(cell_width(translate(word)) for key, word in words.items() if key is not AlarmStage.SHELVED)


def _advice(alarm: Alarm, width: int, whose: str = "") -> list[Row]:
    """Return the operator's action for an alarm that still needs one, with `whose` it is if there are
    several."""
    if not alarm.holds or alarm.stage is AlarmStage.SHELVED or width >= UNBOUNDED:
        return []
    action = translate(action_of(alarm.condition))
    lines = wrap(whose + action, max(LEAST, width - 1 - INDENT))
    return [Row(None, ((" " * INDENT + line, StyleRole.TEXT),)) for line in lines]


def unacknowledged(state: FleetState) -> list[Key]:
    """Return the unacknowledged alarms, in the order of the rows."""
    return [alarm.key for alarm in sorted(state.alarms, key=urgency) if alarm.needs_acknowledgement]


def alarm_of(state: FleetState, robot: str) -> Key | None:
    """Return the alarm of a robot that an acknowledgement means once it is selected: while some alarms need
    one, only such an alarm."""
    keys = unacknowledged(state) or [alarm.key for alarm in sorted(state.alarms, key=urgency)]
    return next((key for key in keys if key[0] == robot), None)


def _suppressed(state: FleetState) -> int:
    """Count the alarms that another one covers: of the robots in a group, of those behind a link that is
    down, and of the silent ones behind a late one."""
    active = [alarm.condition for alarm in state.alarms if alarm.holds]
    grouped = sum(len(condition.parts) - 1 for condition in active if is_group(condition.kind))
    down = {condition.source for condition in active if condition.kind == "link"}
    late = {condition.source for condition in active if condition.kind == "late"}
    silent = [robot for robot in state.robots.values() if robot.link in late and not state.is_online(robot)]
    apart = {condition.source for condition in active} | {name for one in active for name in one.parts}
    covered = sum(robot.name not in apart for robot in silent)
    return grouped + covered + sum(robot.link in down for robot in state.robots.values())


def _columns(
    state: FleetState,
    clock: Callable[[float], str],
    width: int,
    rest: Callable[[], int],
    is_whole: Callable[[Alarm], bool],
) -> tuple[Column[Alarm], ...]:
    """Return the columns for a pane of `width` cells; `rest` returns those of the text."""
    is_wide = width >= WITH_PRIORITY
    most = max(14, width // 3) if is_wide else 9
    names = _names(state, most)
    shown_clock = clock if is_wide else lambda wall: clock(wall)[:HOURS_MINUTES]

    def signs(alarm: Alarm) -> list[Run]:
        shelf = ""
        if alarm.stage is AlarmStage.SHELVED:
            shelf = tr(" until {wall}", wall=clock(state.wall + alarm.shelved_until - state.now))
        return _signs(alarm, shelf, stages)

    stages, priorities = (_longest(SIGNS), _longest(PRIORITIES)) if is_wide else (1, SHORT)
    return (
        Column("", signs, (stages + 1 + priorities, UNBOUNDED), ""),
        Column(
            N_("robot"),
            lambda alarm: names[alarm.condition.source],
            (7, most),
            "",
            text=lambda alarm: alarm.condition.source,
            sorts=True,
        ),
        Column(
            N_("alarm"),
            lambda alarm: _told(alarm, shown_clock, rest(), is_whole(alarm)),
            head="",
            text=lambda alarm: translate(alarm.text),
            order=lambda alarm: alarm.condition.kind,
        ),
        Column(N_("priority"), text=lambda alarm: translate(PRIORITIES[alarm.condition.priority])),
        Column(N_("stage"), text=lambda alarm: translate(SIGNS[alarm.stage])[2:].strip()),
        Column(
            N_("time"),
            text=lambda alarm: clock(alarm.shown_wall),
            order=lambda alarm: -alarm.shown_wall,
            is_apart=True,
        ),
    )


def _title(state: FleetState) -> Iterator[Run]:
    yield tr("Alarms"), StyleRole.TITLE
    if state.unacknowledged:
        yield tr(" {unacknowledged} new", unacknowledged=state.unacknowledged), StyleRole.ALARM
    if state.shelved:
        yield tr(" {shelved} shelved", shelved=state.shelved), StyleRole.DIM
    if suppressed := _suppressed(state):
        yield tr(" {suppressed} suppressed", suppressed=suppressed), StyleRole.DIM


def _without_alarms(state: FleetState, key: str) -> str:
    """Return what there is in place of alarms: all is clear only if no row of the fleet needs a look."""
    found = len(to_look_at(state))
    if not found:
        return tr("all clear")
    told = translate(
        counted("no alarms, {count} robot to look at", "no alarms, {count} robots to look at", found)
    )
    return f"{told} ({key})" if key else told


def alarm_table(
    state: FleetState,
    clock: Callable[[float], str],
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
    marked: Hashable | None = None,
    key: str = "",
) -> Table:
    """Return every alarm for a pane of `width` cells, as arranged: those that hold, unacknowledged ones
    first, by priority; then those that are over; shelved ones last; oldest first. A row moves when it is
    acknowledged or shelved, and when it needs a person again. `clock` formats Unix seconds as a local
    time. `marked` is the alarm that keys are for: of a few its text is whole and its advice is below
    them; `key` goes to the next robot in trouble."""
    arrangement = arrangement or RowArrangement()
    columns = _columns(state, clock, width, lambda: shown.rest - 1, lambda alarm: alarm is meant)
    alarms = arrangement.arranged(sorted(state.alarms, key=urgency), columns)
    shown, meant = FittedColumns(columns, alarms, width), None
    entries: list[Alarm | Row] = [*alarms]
    if 1 <= len(alarms) <= FEW:
        meant = next((alarm for alarm in alarms if alarm.key == marked), alarms[0])
        whose = f"{sanitize(meant.condition.source)}: " if len(alarms) > 1 else ""
        entries += _advice(meant, width, whose)
    whole = (lambda alarm: alarm is meant) if meant is not None else None
    rows = rows_of(shown, entries, attrgetter("key"), whole)
    empty = arrangement.no_match if state.alarms else _without_alarms(state, key)
    return Table((*_title(state), *arrangement.notes(len(alarms))), rows, empty, unfiltered=len(state.alarms))
