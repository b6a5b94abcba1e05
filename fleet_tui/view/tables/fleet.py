"""The fleet pane: one row for each robot, calm while nothing needs a person."""

import math
from functools import partial

from fleet_tui.model.fleet import FleetState, is_missing, missing_text
from fleet_tui.model.order import Order, Stop, pose_text, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.trouble import acknowledged, in_trouble, shelved
from fleet_tui.rules.commands.local_queue import all_orders, foreign
from fleet_tui.text.durations import age
from fleet_tui.text.sanitize import cell_width, fit, sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.fleet_columns import BAR, Columns, floor_text
from fleet_tui.view.tables.news import failed_command, news, shortened_news
from fleet_tui.view.tables.progress import progress_text
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, width_of

CARGO = "▪"
STILL_FROM = 5.0
"""Seconds from which a robot stands still."""
LONG_STILL = 30.0
"""Seconds from which that comes before its order in a narrow pane: longer than loading takes."""
WHOLE_ROUTES = 26
"""Cells of the last column from which orders without a column of their own have their start, too."""
SEEN_FROM = 2.0
"""Seconds from which the age of a robot's last message is shown."""


def place(robot: Robot, vertex: str) -> str:
    """Return a vertex as an operator reads it; one missing from every graph of the robot is marked."""
    name = robot.name_of(vertex)
    return sanitize(name) if name is not None else f"{sanitize(vertex)}?"


def mission(robot: Robot, order: Order) -> str:
    """Return `A -> B` by labels."""
    return sanitize(order.label) if order.label and not order.stops else way(robot, order.stops)


def _destinations(robot: Robot, order: Order) -> str:
    """Return an order without its start, `-> B`, empty for one without two stops."""
    names = [place(robot, stop.vertex) if stop.pose is None else pose_text(stop.pose) for stop in order.stops]
    return "".join(f"-> {name} " for name in names[1:]).rstrip()


def whose_mission(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the mission, marked if another client gave it, for robots without a queue."""
    ours = not robot.kind.keeps_goals or order.is_over or order not in foreign(state, robot)
    return mission(robot, order) + ("" if ours else " (not ours)")


def way(robot: Robot, stops: tuple[Stop, ...]) -> str:
    """Return stops by their labels."""
    return route_text(stops, partial(place, robot))


def _battery(state: FleetState, robot: Robot) -> Run:
    if robot.battery is None:
        return "  - %" if "battery" in robot.kind.reports else " " * 5, StyleRole.DIM
    percent = robot.battery.value
    if not state.is_online(robot):
        role = StyleRole.DIM
    else:
        role = StyleRole.ALARM if percent < state.limits.battery_low else StyleRole.GOOD
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", role


def _battery_bar(state: FleetState, robot: Robot) -> Run:
    """Return the battery as a bar: quiet, unless it is low."""
    if robot.battery is None or not math.isfinite(robot.battery.value):
        return "", StyleRole.DIM
    cells = math.ceil(min(max(robot.battery.value, 0.0), 100.0) / 100 * BAR)
    role = _battery(state, robot)[1]
    return "━" * cells + "┄" * (BAR - cells), role if role is StyleRole.ALARM else StyleRole.DIM


def _signed(state: FleetState, robot: Robot, troubled: bool, shelved: bool) -> Run:
    """Return the sign at the start of a row: offline, in trouble, with its trouble shelved, or all well."""
    if not state.is_online(robot):
        is_expected = robot.last_received is None and not troubled  # it may be switched off for today
        return "○ ", StyleRole.DIM if is_expected else StyleRole.ALARM
    if troubled:
        return "▲ ", StyleRole.ALARM
    return ("◇ ", StyleRole.WARN) if shelved else ("● ", StyleRole.GOOD)


def _seen_row(row: Row) -> Row:
    """Return a row as the alarm pane has acknowledged alarms: with their sign, and without red."""
    (sign, _), *_ = row.runs
    runs = [(text, StyleRole.TEXT if role is StyleRole.ALARM else role) for text, role in row.runs]
    return Row(row.key, ((sign.replace("▲", "△"), runs[0][1]), *runs[1:]))


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
        runs += [_battery(state, robot), (" ", role)]
    if columns.bar:
        text, colour = _battery_bar(state, robot)
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
    if robot.standing is None or not state.is_fresh(robot, "pose"):
        return ""
    return f"still {age(robot.still_for)}" if robot.still_for >= STILL_FROM else "moving"


def _movement_role(state: FleetState, robot: Robot) -> StyleRole:
    if any(alarm.holds and alarm.key == (robot.name, "stuck") for alarm in state.alarms):
        return StyleRole.ALARM
    waits = robot.orders.current is not None and robot.still_for >= LONG_STILL and _movement(state, robot)
    return StyleRole.WARN if waits else StyleRole.DIM


def _without_order(state: FleetState, robot: Robot) -> str:
    """Return the state of a robot that drives no order."""
    if not state.is_online(robot) or not robot.kind.lists_orders:
        return ""
    waiting = sum(not order.is_over for order in all_orders(state, robot))
    if robot.queue is None and not waiting:
        return missing_text(state, robot, "queue")
    return f"{waiting} waiting" if waiting else "idle"


def _row(state: FleetState, robot: Robot, sign: Run, selected: bool, columns: Columns) -> Row:
    role = StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM
    found = [run for text, colour in news(state, robot) for run in ((text, colour), (" ", role))]
    runs = shortened_news(found, columns.state)
    movement = _movement_role(state, robot)
    current, order = robot.orders.current, ""
    if current is None:
        runs = runs or [(_without_order(state, robot), StyleRole.DIM), (" ", role)]
    runs = [run for failed in failed_command(state, robot) for run in (failed, (" ", role))] + runs
    is_odd = movement is StyleRole.WARN or any(colour is StyleRole.WARN for _, colour in runs)
    if sign[1] is StyleRole.GOOD and is_odd:
        sign = sign[0], StyleRole.WARN
    shown = current or next((one for one in all_orders(state, robot) if not one.is_over), None)
    if shown is not None and (columns.order or shown is current):
        order = whose_mission(state, robot, shown)
    progress = progress_text(state, robot, current) if current is not None else ""
    if not columns.order:
        if current is not None and not runs and _movement(state, robot) and robot.still_for >= LONG_STILL:
            runs = [(_movement(state, robot), movement), (" ", role)]
        if shown is not None and columns.state < WHOLE_ROUTES:
            order = _destinations(robot, shown) or order
        mission = "  ".join(part for part in (order, progress) if part)
        if runs and cell_width(mission) > columns.state - width_of(runs):
            mission = ""  # a letter of it tells nothing
        return Row(robot.name, (*_head(state, robot, sign, selected, columns), *runs, (mission, role)))
    if current is not None and not runs:
        runs = [(progress or _movement(state, robot), movement)]
    placed = fit(order, columns.order - 1) + " ", role if shown is current else StyleRole.DIM
    return Row(robot.name, (*_head(state, robot, sign, selected, columns), placed, *runs))


def fleet_table(state: FleetState, selected: str, width: int) -> Table:
    """The whole fleet for a pane of `width` cells: robots with an alarm first, then those in shelved trouble
    or without a pose, else in the order of the config."""
    troubled, silenced, seen = in_trouble(state), shelved(state), acknowledged(state)

    def calm(robot: Robot) -> int:
        is_odd = robot.name in silenced or is_missing(state, robot, "pose")
        return 0 if robot.name in troubled else 1 if is_odd else 2

    robots = sorted(state.robots.values(), key=calm)
    online = sum(state.is_online(robot) for robot in robots)
    columns = Columns.of(state, width)

    def row(place: int) -> Row:
        robot = robots[place]
        sign = _signed(state, robot, robot.name in troubled, robot.name in silenced)
        made = _row(state, robot, sign, robot.name == selected, columns)
        return _seen_row(made) if robot.name in seen else made

    rows = LateRows([robot.name for robot in robots], row)
    title = ("Fleet", StyleRole.TITLE), (f" {online} of {len(rows)} online", StyleRole.DIM)
    return Table(title, rows, head=columns.head)
