"""The alarm pane: conditions that need a person, and unacknowledged alarms."""

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from textwrap import wrap

from msgspec.structs import replace

from fleet_tui.model.alarm import Alarm, AlarmStage, Key, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.alarms.classes import action_of
from fleet_tui.rules.alarms.floods import is_group
from fleet_tui.rules.alarms.trouble import to_look_at, urgency
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import cell_width, fit, folded, sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.arrangement import RowArrangement
from fleet_tui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.view.tables.short_names import own_names
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, column

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
REST_AT = 2
LEAST_REST = 10
"""Cells before the rest of a long text, and those that each of its lines has at least."""
FEW = 4
"""Alarms up to which one of them has its advice in view."""


def _role(alarm: Alarm) -> StyleRole:
    if not alarm.holds:
        return StyleRole.DIM
    if alarm.stage is AlarmStage.UNACKNOWLEDGED:
        return StyleRole.WARN if alarm.condition.priority is Priority.LOW else StyleRole.ALARM
    return StyleRole.TEXT if alarm.stage is AlarmStage.ACKNOWLEDGED else StyleRole.DIM


def _row(
    state: FleetState, alarm: Alarm, names: Mapping[str, str], clock: Callable[[float], str], width: int
) -> Row:
    role = _role(alarm)
    count = f" x{alarm.count}" if alarm.count > 1 else ""
    shelf = ""
    if alarm.stage is AlarmStage.SHELVED:
        shelf = tr(" until {wall}", wall=clock(state.wall + alarm.shelved_until - state.now))
    is_wide = width >= WITH_PRIORITY
    at = clock(alarm.shown_wall)
    runs = _signs(alarm, shelf, is_wide, role)
    runs.append((names[alarm.condition.source] + " ", StyleRole.TEXT))
    left = width - 1 - sum(cell_width(text) for text, _ in runs)
    text = _short(translate(sanitize(alarm.text)), left)
    since = f" {at if is_wide else at[:HOURS_MINUTES]}"
    # Half a time is none.
    since = since if cell_width(text + since + count) <= left else ""
    runs += [(text, role), (since + count, StyleRole.DIM)]
    return Row(alarm.key, tuple(runs))


def _names(state: FleetState, alarms: Sequence[Alarm], width: int) -> Mapping[str, str]:
    """Return the name of each source in the cells of their column: if one is too long, those of fleets have
    the robot's own part alone where it tells the robots apart."""
    most = max(14, width // 3) if width >= WITH_PRIORITY else 9
    sources = {alarm.condition.source for alarm in alarms}
    names = {source: source for source in sources}
    if max(map(cell_width, sources), default=0) > most:
        own = own_names(tuple(state.robots))
        names |= {one: own[one] for one in sources if one in own}
    cells = column(names.values(), 7, most)
    return {one: fit(name, cells) for one, name in names.items()}


def _signs(alarm: Alarm, shelf: str, is_wide: bool, role: StyleRole) -> list[Run]:
    """Return stage and priority, in a narrow pane the stage as a sign: what is most urgent as a chip, like a
    robot's on the map."""
    sign, priority = SIGNS[alarm.stage], alarm.condition.priority
    if is_wide:
        signs = list(SIGNS.values())[:-1]
        text = f"{_padded(sign, signs)}{shelf} {_padded(PRIORITIES[priority], PRIORITIES.values())}"
    else:
        text = f"{sign[0]} {translate(SHORT_PRIORITIES[priority])[:SHORT]}{shelf}"
    if alarm.needs_acknowledgement and alarm.holds and alarm.condition.priority is Priority.HIGH:
        chip = text.rstrip()
        return [(chip, StyleRole.ROBOT_ALARM), (text[len(chip) :] + " ", role)]
    is_known = alarm.holds and alarm.stage is AlarmStage.ACKNOWLEDGED
    return [(text + " ", StyleRole.WARN if is_known else role)]


def _padded(word: Message, others: Iterable[Message]) -> str:
    """Return a word in the cells of the longest of its column."""
    return f"{translate(word):<{max(cell_width(translate(one)) for one in others)}}"


def _in_full(row: Row, alarm: Alarm, width: int) -> list[Row]:
    """Return the row of an alarm; if it would be cut, the rest of its text below: at its end is the cause."""
    text, role = translate(sanitize(alarm.text)), row.runs[-2][1]
    head = row.runs[:-2]
    left = width - sum(cell_width(part) for part, _ in head)
    if cell_width(text) <= left:
        return [row]
    first, *rest = folded(text, max(LEAST_REST, left), max(LEAST_REST, width - 1 - REST_AT))
    return [replace(row, runs=(*head, (first, role))), *(_below(line, role) for line in rest)]


def _below(text: str, role: StyleRole) -> Row:
    return Row(None, ((" " * REST_AT + text, role),))


def _advice(alarm: Alarm, width: int, whose: str = "") -> list[Row]:
    """Return the operator's action for an alarm that still needs one, with `whose` it is if there are
    several."""
    if not alarm.holds or alarm.stage is AlarmStage.SHELVED or width >= UNBOUNDED:
        return []
    action = translate(action_of(alarm.condition))
    lines = wrap(whose + action, max(LEAST_REST, width - 1 - REST_AT))
    return [_below(line, StyleRole.TEXT) for line in lines]


def _explained(
    rows: Sequence[Row], alarms: Sequence[Alarm], marked: Hashable | None, width: int
) -> list[Row]:
    """Return the rows with the whole text of the marked one, and below all its advice."""
    place = next((n for n, alarm in enumerate(alarms) if alarm.key == marked), 0)
    meant = alarms[place]
    whose = f"{sanitize(meant.condition.source)}: " if len(alarms) > 1 else ""
    full = _in_full(rows[place], meant, width)
    return [*rows[:place], *full, *rows[place + 1 :], *_advice(meant, width, whose)]


def _short(text: str, cells: int) -> str:
    """Return a text without the detail at its end, in brackets, if it is too long with it."""
    return text.rpartition(" (")[0] if text.endswith(")") and cell_width(text) > cells else text


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


def _columns(clock: Callable[[float], str]) -> tuple[Column[Alarm], ...]:
    return (
        Column(N_("robot"), text=lambda alarm: alarm.condition.source, sorts=True),
        Column(
            N_("alarm"), text=lambda alarm: translate(alarm.text), order=lambda alarm: alarm.condition.kind
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
    alarms = arrangement.arranged(sorted(state.alarms, key=urgency), _columns(clock))
    names = _names(state, alarms, width)
    keys = [alarm.key for alarm in alarms]
    rows: Sequence[Row] = LateRows(keys, lambda place: _row(state, alarms[place], names, clock, width))
    if 1 <= len(alarms) <= FEW:
        rows = _explained(rows, alarms, marked, width)
    empty = arrangement.no_match if state.alarms else _without_alarms(state, key)
    return Table((*_title(state), *arrangement.notes(len(alarms))), rows, empty, unfiltered=len(state.alarms))
