"""What robots say in words: a line of /rosout when something happens to one, /diagnostics once a second."""

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.robot import EMPTY, LOW, Robot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.ros1 import ROS1

Message = dict[str, Any]

ROSOUT, DIAGNOSTICS = "/rosout", "/diagnostics"
DEBUG, INFO, WARN, ERROR = 1, 2, 4, 8  # rosgraph_msgs/Log
HEALTHY, DOUBTFUL, BROKEN = 0, 1, 2  # diagnostic_msgs/DiagnosticStatus
KEPT = 1000  # lines of the log for late subscribers

Line = tuple[int, str, str]
"""Level, node and words."""


@dataclass(frozen=True)
class _Seen:
    """A robot as it was at the last look."""

    last_order: int
    current: int
    loaded: bool
    obstacle: bool
    paused: bool
    stuck: bool
    low: bool
    floor: str
    vertex: int


def _seen(robot: Robot) -> _Seen:
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


class Talk:
    """Notices what happens to robots from one look to the next."""

    def __init__(self, dialect: Dialect = ROS1) -> None:
        self._seen: dict[str, _Seen] = {}
        self._dialect = dialect
        self._kept: deque[Message] = deque(maxlen=KEPT)
        self._said = count(1)

    def lines(self, robots: dict[str, Robot], now: float) -> list[Message]:
        """What they have to say of what happened since the last look, as messages of /rosout."""
        said = []
        for name, robot in robots.items():
            seen = _seen(robot)
            before = self._seen.get(name)
            self._seen[name] = seen
            if before is not None and before != seen and not robot.silence:
                said += [self._log(robot, line, now) for line in _changes(before, seen, robot)]
        return said

    def say(self, now: float, level: int, node: str, text: str) -> Message:
        """A line as a message of /rosout; it is kept for those who subscribe later."""
        line = self._dialect.log(next(self._said), now, level, node, text)
        self._kept.append(line)
        return line

    def latched(self) -> Iterator[Payload]:
        """The lines for a new subscriber: the last of each node, or all that are kept."""
        newest = {line["name"]: line for line in self._kept}.values()
        yield from map(Payload, self._kept if self._dialect.keeps_log else newest)

    def _log(self, robot: Robot, line: Line, now: float) -> Message:
        level, node, words = line
        return self.say(now, level, f"/{robot.name}/{node}", words)


def _changes(before: _Seen, now: _Seen, robot: Robot) -> Iterator[Line]:
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
        words = "obstacle in front of the laser" if now.obstacle else "the way is free again"
        yield (WARN if now.obstacle else INFO), "laser", words
    if now.paused != before.paused:
        yield WARN, "drive", "brakes on" if now.paused else "brakes off"
    if now.stuck and not before.stuck:
        yield ERROR, "drive", "wheels turn, odometry does not change"
    if now.low and not before.low:
        yield WARN, "battery", f"{robot.battery:.1f} %, charging soon"


def _order_changes(before: _Seen, now: _Seen, robot: Robot) -> Iterator[Line]:
    if before.current != -1 and all(order.id != before.current for order in robot.orders):
        yield INFO, "planner", f"order {before.current} has left the queue"
    if now.current != -1:
        yield DEBUG, "planner", f"working on order {now.current}"


def word_topics(robots: dict[str, Robot], dialect: Dialect, talk: Talk) -> Iterator[Topic]:
    """The topics; a line of the log is only there at the moment at which it is said."""
    log = dialect.message_type("rosgraph_msgs/Log")
    yield Topic(ROSOUT, log, lambda _now: Payload({}), latched=True, history=talk.latched)
    diagnostics = dialect.message_type("diagnostic_msgs/DiagnosticArray")
    yield Topic(DIAGNOSTICS, diagnostics, lambda now: Payload(health(robots, now, dialect)))


def health(robots: dict[str, Robot], now: float, dialect: Dialect = ROS1) -> Message:
    """A message of /diagnostics about every robot that can be heard."""
    parts = [part for robot in robots.values() if not robot.silence for part in _parts(robot)]
    return {"header": dialect.header(0, now, ""), "status": parts}


def _parts(robot: Robot) -> Iterator[Message]:
    empty, low = robot.battery < EMPTY, robot.battery < LOW
    level = BROKEN if empty else DOUBTFUL if low else HEALTHY
    charge = "empty" if empty else "low" if low else "charged"
    yield _status(robot, "battery", level, charge, percent=f"{robot.battery:.1f}")
    slips = robot.stuck and robot.current_order_id != -1
    drive = "no odometry" if slips else "brakes on" if robot.paused else "ready"
    x, y = f"{robot.pose.x:.2f}", f"{robot.pose.y:.2f}"
    yield _status(robot, "drive", BROKEN if slips else HEALTHY, drive, x=x, y=y)
    blocked = robot.obstacle > 0.0
    words = "something is close" if blocked else "clear"
    contact = f"{robot.obstacle:.1f}"
    yield _status(robot, "laser", DOUBTFUL if blocked else HEALTHY, words, contact_s=contact)


def _status(robot: Robot, part: str, level: int, words: str, **values: str) -> Message:
    return {
        "level": level,
        "name": f"{robot.name}: {part}",
        "message": words,
        "hardware_id": f"{part}-{robot.index:03d}",
        "values": [{"key": key, "value": value} for key, value in values.items()],
    }
