"""Texts about the robots: lines of /rosout, entries of /diagnostics."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.logs import BROKEN, DEBUG, DOUBTFUL, ERROR, HEALTHY, INFO, WARN, entry
from fleet_tui.simulator.robot import EMPTY, LOW, SimRobot

Message = dict[str, Any]


@dataclass(frozen=True)
class _Seen:
    """The state of a robot at the last call."""

    last_order: int
    current: int
    loaded: bool
    obstacle: bool
    paused: bool
    stuck: bool
    low: bool
    floor: str
    vertex: int


def _seen(robot: SimRobot) -> _Seen:
    return _Seen(
        robot.last_order_id,
        robot.current_order_id,
        robot.cargo,
        robot.obstacle > 0.0,
        robot.paused,
        robot.stuck and robot.current_order_id != -1,
        robot.battery < LOW,
        robot.floor.name,
        robot.vertex,
    )


class Changes:
    """Detects the changes of robots between two calls."""

    def __init__(self, robots: Mapping[str, SimRobot]) -> None:
        self._robots = robots
        self._seen: dict[str, _Seen] = {}

    def lines(self) -> Iterator[Line]:
        """Return the log lines for everything that happened since the last call."""
        for name, robot in self._robots.items():
            seen, before = _seen(robot), self._seen.get(name)
            self._seen[name] = seen
            if before is not None and before != seen and not robot.silence:
                for level, node, message in _changes(before, seen, robot):
                    yield level, f"/{name}/{node}", message


def _changes(before: _Seen, now: _Seen, robot: SimRobot) -> Iterator[Line]:
    if now.last_order > before.last_order:
        order = next((one for one in robot.orders if one.id == now.last_order), None)
        way = f": {order.start} -> {order.end}" if order else ""
        yield INFO, "planner", f"took order {now.last_order}{way}"
    if now.current != before.current:
        yield from _order_changes(before, now, robot)
    if now.loaded != before.loaded:
        yield INFO, "lift", "cargo is on board" if now.loaded else "cargo is unloaded"
    if now.floor != before.floor:
        yield INFO, "navigation", f"now on {now.floor}"
    if now.vertex != before.vertex:
        yield DEBUG, "navigation", f"at vertex {now.vertex}"
    if now.obstacle != before.obstacle:
        message = "obstacle in front of the laser" if now.obstacle else "the obstacle is gone"
        yield (WARN if now.obstacle else INFO), "laser", message
    if now.paused != before.paused:
        yield WARN, "drive", "brakes on" if now.paused else "brakes off"
    if now.stuck and not before.stuck:
        yield ERROR, "drive", "wheels turn, odometry does not change"
    if now.low and not before.low:
        yield WARN, "battery", f"{robot.battery:.1f} %, charging soon"


def _order_changes(before: _Seen, now: _Seen, robot: SimRobot) -> Iterator[Line]:
    if before.current != -1 and all(order.id != before.current for order in robot.orders):
        yield INFO, "planner", f"order {before.current} has left the queue"
    if now.current != -1:
        yield DEBUG, "planner", f"working on order {now.current}"


def health(robot: SimRobot) -> Iterator[Message]:
    """The entries of /diagnostics about one robot."""
    empty, low = robot.battery < EMPTY, robot.battery < LOW
    level = BROKEN if empty else DOUBTFUL if low else HEALTHY
    charge = "empty" if empty else "low" if low else "charged"
    yield entry(robot, "battery", level, charge, percent=f"{robot.battery:.1f}")
    slips = robot.stuck and robot.current_order_id != -1
    drive = "no odometry" if slips else "brakes on" if robot.paused else "ready"
    x, y = f"{robot.pose.x:.2f}", f"{robot.pose.y:.2f}"
    yield entry(robot, "drive", BROKEN if slips else HEALTHY, drive, x=x, y=y)
    blocked = robot.obstacle > 0.0
    message = "something is close" if blocked else "clear"
    contact = f"{robot.obstacle:.1f}"
    yield entry(robot, "laser", DOUBTFUL if blocked else HEALTHY, message, contact_s=contact)
