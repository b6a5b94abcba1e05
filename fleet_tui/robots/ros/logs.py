"""/rosout and /diagnostics of ROS 1 and ROS 2."""

import base64
import binascii
import re
from collections.abc import Collection, Iterable, Iterator

import msgspec

from fleet_tui.model.navigation_events import ErrorReported
from fleet_tui.model.ros_logs import (
    Health,
    LogLine,
    PartDiagnosis,
    Severity,
    named,
    part_of,
    plain,
    tells_causes,
)
from fleet_tui.robots.ros.messages import Stamp, reader
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import LONGEST_NAME, truncate

LONGEST_TEXT = 2000
"""Characters of a line of the log."""
MOST_PARTS = 500
"""Parts of one message of /diagnostics."""
MOST_VALUES = 50
"""Values of one part."""

LOG_TYPES = ("rosgraph_msgs/Log", "rcl_interfaces/msg/Log")
HEALTH_TYPES = ("diagnostic_msgs/DiagnosticArray", "diagnostic_msgs/msg/DiagnosticArray")


class LogHeader(msgspec.Struct, frozen=True):
    """The fields used of a log line's std_msgs/Header."""

    stamp: Stamp = Stamp()


class Log(msgspec.Struct, frozen=True):
    """rosgraph_msgs/Log, and rcl_interfaces/msg/Log: their common fields."""

    level: int
    name: str
    msg: str
    stamp: Stamp = Stamp()
    header: LogHeader = LogHeader()


class KeyValue(msgspec.Struct, frozen=True):
    """diagnostic_msgs/KeyValue."""

    key: str
    value: str


class DiagnosticStatus(msgspec.Struct, frozen=True):
    """diagnostic_msgs/DiagnosticStatus. A ROS 2 bridge writes the byte `level` as a number, as text or as a
    list, depending on its version."""

    level: int | str | list[int]
    name: str
    message: str = ""
    hardware_id: str = ""
    values: list[KeyValue] = []


class DiagnosticArray(msgspec.Struct, frozen=True):
    """diagnostic_msgs/DiagnosticArray."""

    status: list[DiagnosticStatus]


_read_log = reader(Log)
_read_array = reader(DiagnosticArray)


class RobotNames:
    """The names of the robots behind a bridge, found in those of nodes and of parts."""

    def __init__(self, robots: Collection[str]) -> None:
        self.expression = named(robots)
        self._only = next(iter(robots), "") if len(robots) == 1 else ""

    def robot_of(self, text: str) -> str:
        """Return the robot that a node or a part belongs to, empty if that is unknown; the only robot of a
        bridge has all of them."""
        found = self.expression.search(text)
        return self._only or (found[1] if found else "")


def log_line(msg: object, at: float) -> LogLine:
    """Return a message of /rosout that arrived at `at`. Raises WireError."""
    log = _read_log(msg)
    stamp = log.header.stamp.seconds or log.stamp.seconds
    return LogLine(at, log.level, truncate(log.name, LONGEST_NAME), truncate(log.msg, LONGEST_TEXT), stamp)


# With the id of the operation, which here names the topic.
_COMPLAINT = re.compile(r"\[id: subscribe:(?P<topic>[^\]]+)\]\s*(?:subscribe:\s*)?(?P<reason>.+)", re.DOTALL)


_NOT_ALLOWED = re.compile(
    r"No match found for (?P<what>topic|service|action), cancelling [a-z ]+: (?P<name>\S+)"
)
NOT_ALLOWED = "not in its topics_glob"


def not_allowed(line: LogLine, what: str) -> str:
    """Return the `topic` to which a bridge allows no subscription, or the `service` or `action` to
    which it allows no call, empty for any other line."""
    found = _NOT_ALLOWED.search(line.text) if "rosbridge" in line.node else None
    return found["name"] if found and found["what"] == what else ""


def complaint(line: LogLine) -> tuple[str, str] | None:
    """Return topic and reason of a subscription that a bridge of ROS 2 rejected. That is only in its own log;
    None for any other line."""
    if topic := not_allowed(line, "topic"):
        return topic, NOT_ALLOWED
    if "rosbridge" not in line.node or (line.severity or Severity.DEBUG) < Severity.ERROR:
        return None
    found = _COMPLAINT.search(line.text)
    return (found["topic"], found["reason"]) if found else None


def logged_errors(line: LogLine, robots: RobotNames) -> Iterator[ErrorReported]:
    """Yield what a line of the log tells about why one of the robots does not drive."""
    robot = robots.robot_of(line.node) if tells_causes(line) else ""
    if robot:
        is_warning = line.severity is Severity.WARN
        yield ErrorReported(robot, line.at, plain(line.text), stamp=line.stamp, is_warning=is_warning)


def diagnosed_errors(parts: Iterable[PartDiagnosis], robots: RobotNames) -> Iterator[ErrorReported]:
    """Yield the errors of the robots' parts."""
    for part in parts:
        robot = robots.robot_of(f"{part.name} {part.hardware}") if part.level == Health.ERROR else ""
        if robot:
            text = f"{part_of(robots.expression, part.name)}: {part.message}"
            yield ErrorReported(robot, part.at, text, is_diagnosed=True)


def byte(value: int | str | list[int]) -> int:
    """Return a byte as a number: from a number, a list of one, base64 or the character itself. Raises
    WireError."""
    if isinstance(value, str):
        return _byte_of_text(value)
    if isinstance(value, list):
        if len(value) != 1:
            raise WireError(f"level: a list of {len(value)} numbers is not a byte")
        value = value[0]
    return value


def _byte_of_text(value: str) -> int:
    if len(value) == 1:
        return int(value) if value in "0123456789" else ord(value)
    try:
        (found,) = base64.b64decode(value, validate=True)
    except (binascii.Error, ValueError):
        raise WireError(f"level: {truncate(value, 20)!r} is not a byte") from None
    return found


def diagnoses(msg: object, at: float) -> list[PartDiagnosis]:
    """Return a message of /diagnostics that arrived at `at`, part by part. Raises WireError."""
    return [_diagnosis(status, at) for status in _read_array(msg).status[:MOST_PARTS]]


def _diagnosis(status: DiagnosticStatus, at: float) -> PartDiagnosis:
    return PartDiagnosis(
        at,
        truncate(status.name, LONGEST_NAME),
        byte(status.level),
        truncate(status.message),
        truncate(status.hardware_id, LONGEST_NAME),
        tuple((truncate(one.key, LONGEST_NAME), truncate(one.value)) for one in status.values[:MOST_VALUES]),
    )
