"""The fleet pane: one row for each robot, calm while nothing needs a person."""

import math
import re
from collections.abc import Collection, Mapping
from functools import partial
from operator import attrgetter

from fleet_tui.model.fleet import FleetState, is_missing, missing_text
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.trouble import acknowledged, by_urgency, is_odd, may_need_person, shelved, waits
from fleet_tui.rules.commands.local_queue import all_orders
from fleet_tui.rules.history.activity import MOVES_WITHIN
from fleet_tui.rules.localisation.jumps import is_jumping
from fleet_tui.rules.why.robot import charges
from fleet_tui.text.durations import age
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, fit
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.arrangement import RowArrangement, Value
from fleet_tui.view.tables.battery import battery_bar, battery_run
from fleet_tui.view.tables.fleet_columns import Columns, floor_text
from fleet_tui.view.tables.fleet_counts import fleet_counts
from fleet_tui.view.tables.groups import GroupHead, head_row
from fleet_tui.view.tables.missions import FOREIGN, destinations, mission, whose_mission
from fleet_tui.view.tables.news import failed_command, is_late, news, shortened_news
from fleet_tui.view.tables.progress import progress_text
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, width_of

CARGO, IDLE, CHARGING = "▪", "idle", "charging"
CALM = (IDLE, CHARGING)
STILL_FROM, STILL_INSTEAD = 5.0, 15.0
"""Seconds from which a robot stands still, and from which that is told in place of its order."""
WHOLE_ROUTES = 26
"""Cells of the last column from which orders without a column of their own have their start, too."""
SEEN_FROM = 2.0
"""Seconds from which the age of a robot's last message is shown."""


def _signed(state: FleetState, robot: Robot, troubled: bool, shelved: bool) -> Run:
    """Return the sign at the start of a row: offline, in trouble, with its trouble shelved, or all well."""
    if not state.is_online(robot):
        if robot.last_received is None and not troubled:  # it may be switched off for today
            return "○ ", StyleRole.DIM
        return "○ ", StyleRole.WARN if is_late(state, robot) else StyleRole.ALARM
    if troubled:
        return "▲ ", StyleRole.ALARM
    return ("◇ ", StyleRole.WARN) if shelved else ("● ", StyleRole.GOOD)


def _seen_row(row: Row) -> Row:
    """Return a row as the alarm pane has acknowledged alarms: without red, but not calm."""
    (sign, _), *_ = row.runs
    runs = [(text, StyleRole.TEXT if role is StyleRole.ALARM else role) for text, role in row.runs]
    return Row(row.key, ((sign.replace("▲", "△"), StyleRole.WARN), *runs[1:]))


def _head(state: FleetState, robot: Robot, sign: Run, selected: bool, columns: Columns) -> list[Run]:
    """Return the start of every row: its sign, number, name, battery, floor, cargo, times."""
    role = StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM
    runs: list[Run] = [
        sign,
        # Where the map has other numbers these are keys, and look like those of the footer.
        (
            f"{columns.number_of(robot):>{columns.number - 1}} ",
            StyleRole.DIM if columns.by_place else StyleRole.KEY,
        ),
        (fit(robot.name, columns.name), StyleRole.ACCENT if selected else role),
    ]
    if columns.battery:
        runs += [battery_run(state, robot), (" ", role)]
    if columns.bar:
        text, colour = battery_bar(state, robot)
        runs.append((fit(text, columns.bar), colour))
    if columns.floor:
        runs.append((fit(columns.floors[floor_text(state, robot)], columns.floor), role))
    if columns.cargo:
        runs.append((f"{CARGO} " if robot.has_cargo else "  ", role))
    if columns.waiting:
        runs.append((f"{_waiting(state, robot) or '':>5} ", StyleRole.DIM))
    if columns.seen:
        runs.append((f"{_seen(state, robot):>6} ", StyleRole.DIM))
    return runs


def _waiting(state: FleetState, robot: Robot) -> int:
    """Return the number of orders that wait for the current one, or for their start."""
    return sum(not (order.is_over or robot.orders.is_current(order)) for order in all_orders(state, robot))


def _seen(state: FleetState, robot: Robot) -> str:
    """Return the age of a robot's last message, empty while it is young."""
    seconds = 0.0 if robot.last_received is None else state.now - robot.last_received
    return age(seconds) if seconds >= SEEN_FROM else ""


def _movement(state: FleetState, robot: Robot) -> str:
    """Return whether a robot with an order moves, empty if nothing fresh tells."""
    if robot.standing is None or not state.is_fresh(robot, "pose") or is_jumping(robot, state.now):
        return ""
    return tr(f"still {age(robot.still_for)}") if robot.still_for >= STILL_FROM else tr("moving")


def _movement_role(state: FleetState, robot: Robot) -> StyleRole:
    if any(alarm.holds and alarm.key == (robot.name, "stuck") for alarm in state.alarms):
        return StyleRole.ALARM
    return StyleRole.WARN if waits(state, robot) else StyleRole.DIM


def _without_order(state: FleetState, robot: Robot) -> str:
    """Return the state of a robot that drives no order."""
    if not state.is_online(robot) or not robot.kind.lists_orders:
        return ""
    waiting = sum(not order.is_over for order in all_orders(state, robot))
    if robot.queue is None and not waiting:
        return tr(missing_text(state, robot, "queue"))
    if waiting:
        return tr(f"{waiting} waiting")
    begins = state.now - state.links[robot.link].since < STILL_FROM  # a first pose is no movement
    if not begins and _movement(state, robot) and robot.still_for < MOVES_WITHIN:
        return tr("moving")
    return tr(CHARGING if charges(state, robot) is not None else IDLE)


def _row(state: FleetState, robot: Robot, sign: Run, selected: bool, columns: Columns) -> Row:
    role = StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM
    failed = list(failed_command(state, robot))
    found = [run for text, colour in (*failed, *news(state, robot)) for run in ((text, colour), (" ", role))]
    movement, current, order = _movement_role(state, robot), robot.orders.current, ""
    runs = shortened_news(found, columns.state + (columns.order if current is None else 0))
    if current is None:
        runs = _with_rest(runs, _without_order(state, robot), 2 * len(failed))
    if sign[1] is StyleRole.GOOD and is_odd(state, robot):
        sign = sign[0], StyleRole.WARN
    shown = current or next((one for one in all_orders(state, robot) if not one.is_over), None)
    if shown is not None and (columns.order or shown is current):
        order = whose_mission(state, robot, shown)
    progress = progress_text(state, robot, current) if current is not None else ""
    if not columns.order:
        if current is not None and not runs and _movement(state, robot) and robot.still_for >= STILL_INSTEAD:
            runs = [(_movement(state, robot), movement), (" ", role)]
        if shown is not None and columns.state < WHOLE_ROUTES:
            order = destinations(robot, shown) or order
        # Beside a refused order the current one would read as that.
        told = "" if failed else _after_news(order, progress, columns.state - width_of(runs), bool(runs))
        return Row(robot.name, (*_head(state, robot, sign, selected, columns), *runs, (told, role)))
    if current is not None and not runs:
        shorter = progress if cell_width(progress) < columns.state else progress.partition(", ")[0]
        runs = [(shorter or _movement(state, robot), movement)]
    placed = _placed(order, runs, columns), role if shown is current else StyleRole.DIM
    return Row(robot.name, (*_head(state, robot, sign, selected, columns), placed, *runs))


def _with_rest(runs: list[Run], rest: str, failed: int) -> list[Run]:
    """Return the news of a robot without an order, if there are none but those of a command that failed with
    its state."""
    # "lost idle" would read as one.
    is_told = runs and (len(runs) != failed or rest in map(tr, CALM))
    return runs if is_told else [*runs, (rest, StyleRole.DIM), (" ", StyleRole.TEXT)]


def _placed(order: str, runs: list[Run], columns: Columns) -> str:
    """Return an order in its column, of which a long state takes what the order leaves free."""
    over = max(0, width_of(runs) - 1 - columns.state)
    cells = columns.order - min(over, max(0, columns.order - 2 - cell_width(order)))
    return fit(order, cells - 1) + " "


def _after_news(order: str, progress: str, cells: int, is_news: bool) -> str:
    """Return an order and its progress where there is no column for them: without whose it is, with less of
    the progress, or not at all, if there is no space."""
    shorter = progress.partition(", ")[0]
    for text, far in ((order, progress), (order.removesuffix(tr(FOREIGN)), progress), (order, shorter)):
        told = "  ".join(part for part in (text, far) if part)
        if cell_width(told) <= cells:
            return told
    return "" if is_news else order.removesuffix(tr(FOREIGN))  # beside news a letter of it tells nothing


def _state_text(state: FleetState, robot: Robot) -> str:
    """Return what filters find of a robot's state: its news, or whether it has an order."""
    texts = [text for text, _ in (*failed_command(state, robot), *news(state, robot))]
    if robot.orders.current is None:
        return " ".join(texts or [_without_order(state, robot)])
    return " ".join([*texts, progress_text(state, robot, robot.orders.current) or _movement(state, robot)])


def _order_text(state: FleetState, robot: Robot) -> str:
    return " ".join(mission(robot, order) for order in all_orders(state, robot) if not order.is_over)


def _values(state: FleetState) -> tuple[Value[Robot], ...]:
    return (
        Value("robot", lambda robot: robot.name, lambda robot: natural(robot.name)),
        Value("floor", partial(floor_text, state), lambda robot: natural(floor_text(state, robot))),
        Value("battery", lambda robot: battery_run(state, robot)[0].strip(), _battery_order, is_apart=True),
        Value("order", partial(_order_text, state), lambda robot: not robot.orders.current),
        Value("state", partial(_state_text, state), partial(_state_order, state)),
        Value("kind", lambda robot: robot.kind.name),
        Value("link", lambda robot: robot.link),
    )


def _state_order(state: FleetState, robot: Robot) -> str:
    """Return what sorts by state: its words, for rows with counting seconds would change places."""
    return re.sub(r"[0-9.]+", "", _state_text(state, robot))


def _battery_order(robot: Robot) -> float:
    """Return what sorts by battery: the emptiest first, unknown ones last."""
    return robot.battery.value if robot.battery and math.isfinite(robot.battery.value) else math.inf


def _calm(state: FleetState, troubled: Mapping[str, int], silenced: Collection[str], robot: Robot) -> int:
    """Return what sorts by trouble: the place among those in it, then whatever else is not as usual."""
    first = robot.name in silenced or is_missing(state, robot, "pose") or may_need_person(state, robot)
    return troubled.get(robot.name, len(troubled) if first else len(troubled) + 1)


def fleet_table(
    state: FleetState, selected: str, width: int, arrangement: RowArrangement | None = None
) -> Table:
    """The fleet for a pane of `width` cells, as arranged: robots with an alarm first, in the order of the
    alarms pane, then those in shelved trouble, without a pose, standing with an order or in a mode without
    orders, else in the order of the config."""
    arrangement = arrangement or RowArrangement()
    silenced, seen = shelved(state), acknowledged(state)
    troubled = {name: place for place, name in enumerate(by_urgency(state))}
    calm = partial(_calm, state, troubled, silenced)
    robots = arrangement.arranged(state.robots.values(), _values(state), attrgetter("name"), state.now, calm)
    columns, groups = Columns.of(state, width), arrangement.groups
    entries = groups.grouped(state, robots, selected, opens=bool(arrangement.typed))

    def row(place: int) -> Row:
        robot = entries[place]
        if isinstance(robot, GroupHead):
            return head_row(state, robot, robot in groups.folded and not arrangement.typed, troubled)
        sign = _signed(state, robot, robot.name in troubled, robot.name in silenced)
        made = _row(state, robot, sign, robot.name == selected, columns)
        return _seen_row(made) if robot.name in seen else made

    rows = LateRows([one if isinstance(one, GroupHead) else one.name for one in entries], row)
    notes = arrangement.notes(len(robots))
    # Filtered it is about other numbers.
    counted = [] if arrangement.typed else fleet_counts(state, width - width_of(notes))
    told = ((tr("Fleet"), StyleRole.TITLE), *counted, *notes)
    unfiltered = 0 if groups.by else len(state.robots)
    return Table(told, rows, arrangement.no_match, (), columns.head, unfiltered, bool(groups.by))
