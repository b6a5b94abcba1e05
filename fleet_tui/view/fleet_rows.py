"""The fleet pane: one row for each robot, calm while nothing needs a person."""

from collections.abc import Iterator
from typing import Any

from fleet_tui.model.fleet import FleetState, age, is_paused
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Row, Run, Table, column
from fleet_tui.view.text import fit, visible

CARGO = "■"


def place(robot: Robot, vertex: int) -> str:
    """A vertex as an operator reads it; one that no graph of the robot has is marked."""
    name = robot.name_of(vertex)
    return visible(name) if name is not None else f"{vertex}?"


def mission(robot: Robot, order: Order) -> str:
    """`A -> B` by labels."""
    return f"{place(robot, order.start)} -> {place(robot, order.end)}"


def floor_text(state: FleetState, robot: Robot) -> str:
    """The floor a robot is on, as far as its pose tells."""
    if robot.pose is None:
        return "-"
    return robot.floor or "unknown floor"


def _old(state: FleetState, name: str, reading: Reading[Any] | None) -> Iterator[Run]:
    """A value that has gone quiet while its robot speaks must not look live."""
    if reading is not None and state.now - reading.at > state.limits.offline_after:
        yield f"{name} {age(state.now - reading.at)} old", Ink.WARN


def news(state: FleetState, robot: Robot) -> Iterator[Run]:
    """What a person should know about a robot, the most urgent first."""
    if robot.heard is None:
        yield "never seen", Ink.DIM
    online = state.is_online(robot)
    if not online and robot.heard is not None:
        yield f"offline {age(state.now - robot.heard)}", Ink.ALARM
    if robot.obstacle is not None and state.is_obstructed(robot):
        text = f"obstacle {robot.obstacle.value:.1f} s"
        yield (text, Ink.ALARM) if online else (f"{text} then", Ink.DIM)
    if is_paused(robot):
        yield ("paused" if robot.paused is not None else "paused (by us)"), Ink.WARN
    if online:
        yield from _old(state, "pose", robot.pose)
        yield from _old(state, "battery", robot.battery)
        yield from _old(state, "queue", robot.queue)
    if robot.faults:
        yield f"bad data x{robot.faults}", Ink.WARN


def _battery(state: FleetState, robot: Robot) -> Run:
    if robot.battery is None:
        return "  - %", Ink.DIM
    percent = robot.battery.value
    if not state.is_online(robot):
        ink = Ink.DIM
    else:
        ink = Ink.ALARM if percent < state.limits.battery_low else Ink.GOOD
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", ink


def _row(state: FleetState, robot: Robot, selected: bool, columns: tuple[int, int, int]) -> Row:
    numbers, names, floors = columns
    online = state.is_online(robot)
    ink = Ink.TEXT if online else Ink.DIM
    dot: Run = ("●", Ink.GOOD) if online else ("○", Ink.DIM if robot.heard is None else Ink.ALARM)
    runs: list[Run] = [
        dot,
        (f" {robot.number:{numbers}d} ", Ink.DIM),
        (fit(robot.name, names), Ink.ACCENT if selected else ink),
        (" ", ink),
        _battery(state, robot),
        (" " + fit(floor_text(state, robot), floors), ink),
        (f" {CARGO} " if robot.has_cargo else "   ", Ink.TEXT if online else Ink.DIM),
    ]
    for text, colour in news(state, robot):
        runs += [(text, colour), (" ", ink)]
    current = robot.orders.current
    waiting = len(robot.orders.orders)
    if current is not None:
        runs.append((mission(robot, current), ink))
    elif online:
        runs.append((f"{waiting} waiting" if waiting else "idle", Ink.DIM))
    return Row(robot.name, tuple(runs))


def fleet_table(state: FleetState, selected: str) -> Table:
    """The whole fleet, in the order of the config."""
    robots = state.robots.values()
    online = sum(state.is_online(robot) for robot in robots)
    names = column((robot.name for robot in robots), 6, 14)
    floors = column((floor_text(state, robot) for robot in robots), 5, 13)
    columns = (len(str(len(state.robots))), names, floors)
    rows = tuple(_row(state, robot, robot.name == selected, columns) for robot in robots)
    return Table((("Fleet", Ink.TITLE), (f" {online} of {len(rows)} online", Ink.DIM)), rows)
