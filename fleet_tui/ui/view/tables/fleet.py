"""The fleet pane: one row for each robot, calm while nothing needs a person."""

import math
import re
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from operator import attrgetter

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.robot import Robot
from fleet_tui.model.robot_numbers import marks_of
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.situation.activity import activities
from fleet_tui.situation.alarms.trouble import acknowledged, by_urgency, shelved, to_look_at
from fleet_tui.text.language import N_, tr, translate
from fleet_tui.text.sanitize import cell_width, fit, fit_words
from fleet_tui.text.units import age
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.columns import GAP, Column, FittedColumns
from fleet_tui.ui.view.tables.doing import (
    CALM,
    ODD,
    UNKNOWN,
    count_text,
    count_word,
    missing,
    state_texts,
    with_progress,
    word,
)
from fleet_tui.ui.view.tables.groups import GroupHead, head_row
from fleet_tui.ui.view.tables.missions import (
    FOREIGN,
    destinations,
    distance_left,
    left_text,
    mission,
    progress_text,
    whose_mission,
)
from fleet_tui.ui.view.tables.news import failed_command, in_cells, is_on_its_way, listed, news
from fleet_tui.ui.view.tables.short_names import NO_FLOOR, floor_text, own_names, shortened
from fleet_tui.ui.view.tables.table import LateRows, Row, Run, Table, column, width_of

COUNTED = (
    *ODD,
    Activity.WAITING.value,
    Activity.DRIVING.value,
    Activity.LOADING.value,
    Activity.IDLE.value,
    Activity.CHARGING.value,
    UNKNOWN,
)
"""What robots online do: first what a person looks for."""
BESIDE = 10
RANGE = 7
"""Cells of the title beside the counts, and of `  1-2 of 3` beside its numbers."""
ALL_IN_VIEW = 12
"""Robots up to which nearly every pane has a row for each: of more the title tells which rows are in view."""


CARGO = "▪"
WITH_WORD = 23
WHOLE_ROUTES = 26
"""Cells of the last column from which orders without a column of their own have the word that their robot
drives, and their start, too."""
STATE = 19
WITH_ORDER = 36
ORDER_MOST = 30
"""Cells of usual states (longer ones take some of a short order's), of both from which orders have a column
before them, and of that at most."""
WHOLE_FLOORS = 54
WITH_BAR = 70
WITH_WAITING = 84
WITH_LEFT = 88
WITH_SEEN = 98
DISTANCE = N_("distance")
"""Cells of a pane from which floors have their whole names, and from which it has further columns."""
FLOOR = 2
"""Cells of the floors' column where their names are that short: its head is cut, too."""
BAR = 5
"""Cells of a full battery's bar."""
SEEN_FROM = 2.0
"""Seconds from which the age of a robot's last message is shown."""


def battery_run(state: FleetState, robot: Robot) -> Run:
    """Return the battery in per cent."""
    if robot.battery is None:
        return "  - %" if "battery" in robot.kind.reports else " " * 5, StyleRole.DIM
    percent, limits = robot.battery.value, state.limits
    if not state.is_online(robot):
        role = StyleRole.DIM
    elif percent < limits.battery_critical:
        role = StyleRole.ALARM
    else:
        role = StyleRole.WARN if percent < limits.battery_low else StyleRole.TEXT
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", role


def battery_bar(state: FleetState, robot: Robot) -> Run:
    """Return the battery as a bar: quiet, unless it is low."""
    if robot.battery is None or not math.isfinite(robot.battery.value):
        return "", StyleRole.DIM
    cells = math.ceil(min(max(robot.battery.value, 0.0), 100.0) / 100 * BAR)
    role = battery_run(state, robot)[1]
    is_low = role in (StyleRole.ALARM, StyleRole.WARN)
    return "━" * cells + "┄" * (BAR - cells), role if is_low else StyleRole.DIM


def _signed(state: FleetState, robot: Robot, troubled: bool, shelved: bool, odd: bool) -> Run:
    """Return the sign at the start of a row: offline, in trouble, with its trouble shelved, worth a look,
    or all well."""
    if not state.is_online(robot):
        if robot.last_received is None and not troubled:  # it may be switched off for today
            return "○", StyleRole.DIM
        return "○", StyleRole.WARN if is_on_its_way(state, robot) else StyleRole.ALARM
    if troubled:
        return "▲", StyleRole.ALARM
    return ("◇" if shelved else "●"), StyleRole.WARN if shelved or odd else StyleRole.GOOD


def _seen_row(row: Row) -> Row:
    """Return a row as the alarm pane has acknowledged alarms: without red, but not calm."""
    (sign, _), *_ = row.runs
    runs = [(text, StyleRole.TEXT if role is StyleRole.ALARM else role) for text, role in row.runs]
    return Row(row.key, ((sign.replace("▲", "△"), StyleRole.WARN), *runs[1:]))


def _waiting(state: FleetState, robot: Robot) -> Run:
    """Return the number of orders that wait for the current one, or for their start."""
    count = sum(not (order.is_over or robot.orders.is_current(order)) for order in all_orders(state, robot))
    return str(count or ""), StyleRole.DIM


def _seen(state: FleetState, robot: Robot) -> Run:
    """Return the age of a robot's last message, empty while it is young."""
    seconds = 0.0 if robot.last_received is None else state.now - robot.last_received
    return age(seconds) if seconds >= SEEN_FROM else "", StyleRole.DIM


def _doing(
    state: FleetState, robot: Robot, does: Activity | None, cells: tuple[int, int], has_left: bool
) -> tuple[Run, ...]:
    """Return the order and the state of a robot in the cells of their columns, of which the order may have
    none."""
    role = StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM
    current, order = robot.orders.current, ""
    of_order, of_state = cells
    shown = current or next((one for one in all_orders(state, robot) if not one.is_over), None)
    shorter = destinations(robot, shown) if shown is not None else ""
    if shown is not None:
        order = whose_mission(state, robot, shown)
    free = of_order - min(of_order, cell_width(shorter or order) + 2) if order else of_order
    texts = state_texts(state, robot, does, of_state + free)
    progress = progress_text(state, robot, current, has_left) if current is not None else ""
    if not of_order:
        if shown is not None and of_state < WHOLE_ROUTES:
            order = shorter or order
        # Beside a refused order the current one would read as that.
        order = "" if any(failed_command(state, robot)) else order
        runs = [*in_cells(texts, of_state), GAP]
        return tuple(_with_order(runs, order, progress, of_state, does, role))
    placed = _placed(order, shorter, width_of(listed(texts)), cells)
    left = of_state + of_order - cell_width(placed)
    runs = with_progress([*in_cells(texts, left), GAP], progress, left)
    return (placed, role if shown is current else StyleRole.DIM), *runs


def _with_order(
    runs: list[Run], order: str, progress: str, cells: int, does: Activity | None, role: StyleRole
) -> list[Run]:
    """Return the state and the order where there is no column for it: its arrow alone says that a robot
    drives, if there is no space for both."""
    told = _after_state(order, progress, cells - width_of(runs))
    drives = does is Activity.DRIVING and runs[0][0] == word(does)
    alone = _after_state(order, progress, cells)
    if drives and order and (cells < WITH_WORD or len(told) < len(alone)):
        return [(alone or order.removesuffix(translate(FOREIGN)), role)]
    return [*runs, (told, role)]


def _placed(order: str, shorter: str, state: int, cells: tuple[int, int]) -> str:
    """Return an order in its column, without its start if that is too long. A state of more cells than its
    column takes what the order leaves free, and what that is without its start."""
    of_order, of_state = cells
    over = max(0, state - of_state)
    if cell_width(order) >= of_order or (over and cell_width(order) + over > of_order - 2):
        order = shorter or order
    kept = of_order - min(over, max(0, of_order - 2 - cell_width(order)))
    return fit_words(order, kept - 1) + " "


def _after_state(order: str, progress: str, cells: int) -> str:
    """Return an order and its progress where there is no column for them: without whose it is, with less of
    the progress, or not at all, if there is no space."""
    shorter = progress.partition(", ")[0]
    for text, far in (
        (order, progress),
        (order.removesuffix(translate(FOREIGN)), progress),
        (order, shorter),
    ):
        told = "  ".join(part for part in (text, far) if part)
        if cell_width(told) <= cells:
            return told
    order = order.removesuffix(translate(FOREIGN))
    return order if cell_width(order) <= cells else ""


def _state_text(state: FleetState, done: Mapping[str, Activity], robot: Robot) -> str:
    """Return what filters find of a robot's state: its news, and what it does."""
    texts = [text for text, _ in (*failed_command(state, robot), *news(state, robot))]
    current, does = robot.orders.current, done.get(robot.name)
    if does in CALM and texts:
        return " ".join(texts)
    doing = word(does) if does is not None else missing(state, robot) or word(None)
    return " ".join([*texts, doing, progress_text(state, robot, current) if current is not None else ""])


def _order_text(state: FleetState, robot: Robot) -> str:
    return " ".join(mission(robot, order) for order in all_orders(state, robot) if not order.is_over)


def fleet_columns(
    state: FleetState, done: Mapping[str, Activity], sign: Callable[[Robot], Run], selected: str, width: int
) -> Sequence[Column[Robot]]:
    """Return the columns for a pane of `width` cells, but for order and state, which share what is left.
    Those of values that no robot of the fleet reports are only found."""
    robots = state.robots.values()
    reported = {value for robot in robots for value in robot.kind.reports}
    is_narrow = width < WHOLE_FLOORS
    marks = dict(zip(state.robots, marks_of(tuple(state.robots)), strict=True))
    names = own_names(tuple(state.robots)) if is_narrow else {name: name for name in state.robots}
    known = {floor_text(state, robot) for robot in robots}
    # Of all floors: the column must not change when one gets empty.
    floors = shortened({*state.floors, *known}) if is_narrow else {name: name for name in known}
    is_obvious = is_narrow and len(state.floors) == 1 and known.isdisjoint(NO_FLOOR)
    floor = column(floors.values(), FLOOR if is_narrow else len(tr("Floor")), 13)

    def role(robot: Robot) -> StyleRole:
        return StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM

    def name(robot: Robot) -> Run:
        return names[robot.name], StyleRole.ACCENT if robot.name == selected else role(robot)

    def where(robot: Robot) -> Run:
        return floors[floor_text(state, robot)], role(robot)

    def left(robot: Robot) -> Run:
        current = robot.orders.current
        return left_text(state, robot, current) if current else "", role(robot)

    def by_left(robot: Robot) -> float:
        current = robot.orders.current
        metres = distance_left(state, robot, current) if current else None
        return math.inf if metres is None else metres

    def of(value: str, *columns: Column[Robot]) -> Sequence[Column[Robot]]:
        return columns if value in reported else [replace(one, cell=None) for one in columns]

    return (
        Column("", sign, 1, stays=True),
        Column(
            "",
            lambda robot: (marks[robot.name], StyleRole.DIM),
            column(marks.values(), 1, 4),
            "#",
            is_right=True,
            stays=True,
        ),
        Column(
            N_("robot"),
            name,
            column(names.values(), 6, 14),
            tr("Robot"),
            text=lambda robot: robot.name,
            sorts=True,
            stays=True,
        ),
        *of(
            "battery",
            Column(
                N_("battery"), partial(battery_run, state), 5, tr("Batt"), order=_battery_order, is_apart=True
            ),
            Column("", partial(battery_bar, state), BAR, "", WITH_BAR),
        ),
        *of(
            "" if is_obvious else "pose",
            Column(
                N_("floor"),
                where,
                floor,
                tr("Floor")[: max(FLOOR, floor)],
                text=partial(floor_text, state),
                sorts=True,
            ),
        ),
        *of("cargo", Column("", lambda robot: (CARGO if robot.has_cargo else "", role(robot)), 1, "")),
        *of("queue", Column("", partial(_waiting, state), 5, tr("Queue"), WITH_WAITING, is_right=True)),
        Column(
            DISTANCE,
            left if any(robot.kind.lists_orders for robot in robots) else None,
            8,
            tr("Left"),
            WITH_LEFT,
            order=by_left,
            is_right=True,
        ),
        Column("", partial(_seen, state), 6, tr("Seen"), WITH_SEEN, is_right=True),
        Column(N_("order"), text=partial(_order_text, state), order=lambda robot: not robot.orders.current),
        Column(N_("state"), text=partial(_state_text, state, done), order=partial(_state_order, state, done)),
        Column(N_("kind"), text=lambda robot: robot.kind.name),
        Column(N_("link"), text=lambda robot: robot.link),
    )


def _state_order(state: FleetState, done: Mapping[str, Activity], robot: Robot) -> str:
    """Return what sorts by state: its words, for rows with counting seconds would change places."""
    return re.sub(r"[0-9.]+", "", _state_text(state, done, robot))


def _battery_order(robot: Robot) -> float:
    """Return what sorts by battery: the emptiest first, unknown ones last."""
    return robot.battery.value if robot.battery and math.isfinite(robot.battery.value) else math.inf


def _calm(troubled: Mapping[str, int], odd: Collection[str], robot: Robot) -> int:
    """Return what sorts by trouble: the place among those in it, then whatever else is not as usual."""
    return troubled.get(robot.name, len(troubled) + (robot.name not in odd))


def fleet_table(
    state: FleetState, selected: str, width: int, arrangement: RowArrangement | None = None
) -> Table:
    """The fleet for a pane of `width` cells, as arranged: robots with an alarm first, in the order of the
    alarms pane, then those in shelved trouble or worth a look, else in the order of the config."""
    arrangement = arrangement or RowArrangement()
    silenced, seen, done = shelved(state), acknowledged(state), activities(state, state.robots.values())
    troubled = {name: place for place, name in enumerate(by_urgency(state))}
    odd = {*silenced, *to_look_at(state)}

    def sign(robot: Robot) -> Run:
        return _signed(state, robot, *(robot.name in names for names in (troubled, silenced, odd)))

    columns = fleet_columns(state, done, sign, selected, width)
    calm = partial(_calm, troubled, odd)
    robots = arrangement.arranged(state.robots.values(), columns, attrgetter("name"), state.now, calm)
    shown, groups = FittedColumns(columns, robots, width), arrangement.groups
    of_order = min(shown.rest - STATE, ORDER_MOST) if shown.rest >= WITH_ORDER else 0
    cells = of_order, shown.rest - of_order
    entries = groups.grouped(state, robots, selected, opens=bool(arrangement.typed))

    def row(place: int) -> Row:
        robot = entries[place]
        if isinstance(robot, GroupHead):
            return head_row(state, robot, robot in groups.folded and not arrangement.typed, troubled)
        runs = (*shown.runs(robot), *_doing(state, robot, done.get(robot.name), cells, shown.shows(DISTANCE)))
        return _seen_row(Row(robot.name, runs)) if robot.name in seen else Row(robot.name, runs)

    rows = LateRows([one if isinstance(one, GroupHead) else one.name for one in entries], row)
    notes = arrangement.notes(len(robots))
    # Filtered it is about other numbers.
    counted = [] if arrangement.typed else fleet_counts(state, done, width - width_of(notes))
    return Table(
        ((tr("Fleet"), StyleRole.TITLE), *counted, *notes),
        rows,
        arrangement.no_match,
        head=(*shown.head, (_head(cells), StyleRole.DIM)),
        unfiltered=0 if groups.by else len(state.robots),
        has_groups=bool(groups.by),
        stays=shown.stays,
    )


def _head(cells: tuple[int, int]) -> str:
    of_order, of_state = cells
    both = tr("State, order")
    if of_order or cell_width(both) > of_state:
        return fit(tr("Order"), of_order) + tr("State")
    return both


def fleet_counts(state: FleetState, done: Mapping[str, Activity], width: int) -> list[Run]:
    """Return how many robots are online and what all of them do, by the words of their rows. In less than
    `width` cells that all are online is left out, else only what is odd is told, if need be in the place of
    those online."""
    robots, digits = state.robots, len(str(len(state.robots)))
    left = width - BESIDE - (RANGE + 3 * digits) * (len(robots) > ALL_IN_VIEW)
    found = Counter(count_word(state, robot, done.get(name)) for name, robot in robots.items())
    offline = found.pop(Activity.OFFLINE.value, 0)
    online = len(robots) - offline
    present: Run = (tr(" {online} of {robots} online", online=online, robots=len(robots)), StyleRole.DIM)
    counts = [
        (count_text(found[one], one), StyleRole.WARN if one in ODD else StyleRole.DIM)
        for one in COUNTED
        if found[one]
    ]
    odd = [one for one in counts if one[1] is StyleRole.WARN]
    away = [(f"{offline} {tr(Activity.OFFLINE.value)}", StyleRole.DIM)] if offline else []
    # A part of the counts would not add up.
    listed = [_listed([present], ": ", counts)]
    if not offline:
        listed.append(_listed([(f" {online}", StyleRole.DIM)], ": ", counts))
    listed.append(_listed([present], ": ", odd))
    listed += [_listed([], " ", [*away, *odd][:most]) for most in range(len([*away, *odd]), 0, -1)]
    return next((one for one in listed if width_of(one) <= left), [present])


def _listed(runs: Sequence[Run], first: str, counts: Sequence[Run]) -> list[Run]:
    more = [part for count in counts for part in ((", ", StyleRole.DIM), count)]
    return [*runs, *([(first, StyleRole.DIM), *more[1:]] if counts else [])]
