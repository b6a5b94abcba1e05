"""The fleet pane: one row for each robot, calm while nothing needs a person."""

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.fleet import FleetState, obstacle_text
from fleet_tui.model.navigation import blocked_text
from fleet_tui.model.order import Order, Stop, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.conditions import is_news
from fleet_tui.rules.alarms.navigation import LOST_ABOVE
from fleet_tui.rules.commands.local_queue import all_orders, foreign
from fleet_tui.rules.commands.newest import own_pause
from fleet_tui.rules.commands.pauses import own_pause_text
from fleet_tui.text.durations import age
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.progress import progress_text
from fleet_tui.view.tables.table import LateRows, Row, Run, Table, column, width_of

CARGO = "■"


def place(robot: Robot, vertex: str) -> str:
    """Return a vertex as an operator reads it; one missing from every graph of the robot is marked."""
    name = robot.name_of(vertex)
    return sanitize(name) if name is not None else f"{sanitize(vertex)}?"


def mission(robot: Robot, order: Order) -> str:
    """Return `A -> B` by labels."""
    return sanitize(order.label) if order.label and not order.stops else way(robot, order.stops)


def whose_mission(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the mission, marked if another client gave it, for robots without a queue."""
    ours = not robot.kind.keeps_goals or order.is_over or order not in foreign(state, robot)
    return mission(robot, order) + ("" if ours else " (not ours)")


def way(robot: Robot, stops: tuple[Stop, ...]) -> str:
    """Return stops by their labels."""
    return route_text(stops, partial(place, robot))


def floor_text(state: FleetState, robot: Robot) -> str:
    """Return the floor a robot is on, as far as its pose shows."""
    if robot.pose is None:
        return "-" if "pose" in robot.kind.reports else ""
    return robot.floor or "unknown floor"


def _old(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Yield the old values of a robot that is online: they must not look live."""
    readings = {
        "pose": robot.pose,
        "battery": robot.battery,
        "queue": robot.queue,
        "cargo": robot.cargo,
        "obstacle": robot.obstacle,
        "paused": robot.paused,
    }
    for value, reading in readings.items():
        if reading is not None and state.is_old(robot, value):
            name = "pause" if value == "paused" else value
            yield f"{name} {age(state.now - reading.at)} old", StyleRole.WARN


def _paused(state: FleetState, robot: Robot) -> str:
    if robot.paused is None:
        return own_pause_text(state, robot)
    return "paused" if own_pause(state, robot) else "paused (elsewhere)"


def news(state: FleetState, robot: Robot) -> Iterator[Run]:
    """Return the news of a robot, the most urgent first."""
    online = state.is_online(robot)
    if robot.heard is None:
        yield "never seen", StyleRole.DIM
    elif not online:
        yield f"offline {age(state.now - robot.heard)}", StyleRole.ALARM
    contact = robot.obstacle if state.was_obstructed(robot) else None
    is_old = state.is_old(robot, "obstacle")
    if contact is not None and not is_old:
        yield obstacle_text(state, robot, contact), StyleRole.ALARM
    if robot.blocked is not None and robot.blocked.value.is_stopped and state.is_fresh(robot, "blocked"):
        yield blocked_text(robot.blocked.value, state.now), StyleRole.ALARM
    if robot.variance is not None and robot.variance.value > LOST_ABOVE:
        yield "pose uncertain", StyleRole.WARN
    if state.is_paused(robot):
        yield _paused(state, robot), StyleRole.WARN
    if contact is not None and is_old:
        yield obstacle_text(state, robot, contact), StyleRole.DIM
    if online:
        yield from _old(state, robot)
    if is_news(state, robot.fault_at):
        yield f"bad data x{robot.faults}", StyleRole.WARN


def _battery(state: FleetState, robot: Robot) -> Run:
    if robot.battery is None:
        return "  - %" if "battery" in robot.kind.reports else " " * 5, StyleRole.DIM
    percent = robot.battery.value
    if not state.is_online(robot):
        ink = StyleRole.DIM
    else:
        ink = StyleRole.ALARM if percent < state.limits.battery_low else StyleRole.GOOD
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", ink


class _Columns(NamedTuple):
    """Widths in cells, 0 for a column for which no robot of the fleet has a value."""

    numbers: int
    names: int
    battery: bool
    floors: int
    cargo: int

    @classmethod
    def of(cls, state: FleetState) -> "_Columns":
        robots = state.robots.values()
        reported = {value for robot in robots for value in robot.kind.reports}
        return cls(
            len(str(len(robots))),
            column((robot.name for robot in robots), 6, 14),
            "battery" in reported,
            column({floor_text(state, robot) for robot in robots}, 5, 13) if "pose" in reported else 0,
            3 if "cargo" in reported else 1,
        )


def _head(state: FleetState, robot: Robot, selected: bool, columns: _Columns) -> list[Run]:
    """Return the start of every row: link state, name, battery."""
    online = state.is_online(robot)
    ink = StyleRole.TEXT if online else StyleRole.DIM
    dot: Run = (
        ("●", StyleRole.GOOD) if online else ("○", StyleRole.DIM if robot.heard is None else StyleRole.ALARM)
    )
    return [
        dot,
        (f" {robot.number:{columns.numbers}d} ", StyleRole.DIM),
        (fit(robot.name, columns.names), StyleRole.ACCENT if selected else ink),
        (" ", ink),
        *([_battery(state, robot), (" ", ink)] if columns.battery else []),
    ]


def _doing(state: FleetState, robot: Robot, ink: StyleRole) -> Run:
    current = robot.orders.current
    if current is not None:
        progress = progress_text(state, robot, current)
        return whose_mission(state, robot, current) + (f"  {progress}" if progress else ""), ink
    if not state.is_online(robot) or not robot.kind.lists_orders:
        return "", StyleRole.DIM
    waiting = sum(not order.is_over for order in all_orders(state, robot))
    if robot.queue is None and not waiting:
        return "queue missing" if robot.kind.expects("queue") else "-", StyleRole.DIM
    return f"{waiting} waiting" if waiting else "idle", StyleRole.DIM


def _row(state: FleetState, robot: Robot, head: list[Run], columns: _Columns, width: int) -> Row:
    ink = StyleRole.TEXT if state.is_online(robot) else StyleRole.DIM
    told: list[Run] = [run for text, colour in news(state, robot) for run in ((text, colour), (" ", ink))]
    floor: list[Run] = [
        (fit(floor_text(state, robot), columns.floors), ink),
        (f" {CARGO} " if robot.has_cargo else " " * columns.cargo, ink),
    ]
    # News must not be cut: if both don't fit, the floor is dropped.
    fits = width_of([*head, *floor, *told]) <= width + 1
    middle = [*floor, *told] if fits else [*told, *floor]
    return Row(robot.name, (*head, *middle, _doing(state, robot, ink)))


def in_trouble_first(state: FleetState) -> list[Robot]:
    """Return all robots: those with an alarm that is neither over nor shelved first, each part in the order
    of the config. Its off-delay keeps the rows where they are."""
    over = (AlarmStage.SHELVED, AlarmStage.RETURNED)
    active = [one.condition for one in state.alarms if one.stage not in over]
    named = {name for condition in active for name in (condition.source, *condition.parts)}
    return sorted(state.robots.values(), key=lambda robot: robot.name not in named)


def fleet_table(state: FleetState, selected: str, width: int) -> Table:
    """The whole fleet for a pane of `width` cells: robots with an alarm first, else in the order of the
    config."""
    robots = in_trouble_first(state)
    online = sum(state.is_online(robot) for robot in robots)
    columns = _Columns.of(state)

    def row(place: int) -> Row:
        robot = robots[place]
        head = _head(state, robot, robot.name == selected, columns)
        return _row(state, robot, head, columns, width)

    rows = LateRows([robot.name for robot in robots], row)
    return Table((("Fleet", StyleRole.TITLE), (f" {online} of {len(rows)} online", StyleRole.DIM)), rows)
