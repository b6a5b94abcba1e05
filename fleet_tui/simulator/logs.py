"""Logs and diagnostics: a line of /rosout when something happens, /diagnostics once a second."""

import time
from collections import deque
from collections.abc import Iterator, Sequence
from itertools import count

from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.ros.dialect import ROS1, Dialect, Message
from fleet_tui.simulator.world import Body

ROSOUT = "/rosout"
DIAGNOSTICS = "/diagnostics"
# rosgraph_msgs/Log
DEBUG = 1
INFO = 2
WARN = 4
ERROR = 8
# diagnostic_msgs/DiagnosticStatus
HEALTHY = 0
DOUBTFUL = 1
BROKEN = 2
KEPT = 1000  # lines of the log for late subscribers
KEPT_FOR = 10.0  # seconds for which ROS 2 keeps each


class Talk:
    """The log: each line becomes a message, and is kept for late subscribers."""

    def __init__(self, dialect: Dialect = ROS1) -> None:
        self._dialect = dialect
        self._kept: deque[tuple[float, Message]] = deque(maxlen=KEPT)
        self._said = count(1)

    def say(self, now: float, level: int, node: str, text: str) -> Message:
        """A line as a message of /rosout."""
        line = self._dialect.log(next(self._said), now, level, node, text)
        self._kept.append((now, line))
        return line

    def forget(self, node: str) -> None:
        """Drop the lines of a node that has ended: each keeps its own."""
        left = [one for one in self._kept if one[1]["name"].lstrip("/") != node.lstrip("/")]
        self._kept = deque(left, maxlen=KEPT)

    def latched(self) -> Iterator[Payload]:
        """Return the lines for a new subscriber: the last of each node, or all that are kept."""
        newest = {line["name"]: line for _, line in self._kept}.values()
        recent = [line for at, line in self._kept if at > time.time() - KEPT_FOR]
        yield from map(Payload, recent if self._dialect.keeps_log else newest)


def log_topics(fleets: Sequence[Fleet], dialect: Dialect, talk: Talk) -> Iterator[Topic]:
    """The topics; a line of the log is published only once."""
    log = dialect.message_type("rosgraph_msgs/Log")
    yield Topic(ROSOUT, log, lambda _now: Payload({}), latched=True, history=talk.latched)

    def health(now: float) -> Payload:
        entries = [entry for fleet in fleets for entry in fleet.health()]
        return Payload({"header": dialect.header(0, now, ""), "status": entries})

    yield Topic(DIAGNOSTICS, dialect.message_type("diagnostic_msgs/DiagnosticArray"), health)


def entry(robot: Body, part: str, level: int, message: str, **values: str) -> Message:
    """An entry of /diagnostics about a part of a robot."""
    return {
        "level": level,
        "name": f"{robot.name}: {part}",
        "message": message,
        "hardware_id": f"{part}-{robot.index:03d}",
        "values": [{"key": key, "value": value} for key, value in values.items()],
    }
