"""Logs and diagnostics of robots."""

import re
from collections.abc import Iterable
from enum import IntEnum

from msgspec import Struct

from fleet_tui.text.language import Message


class Severity(IntEnum):
    """The severity of a line of the log."""

    DEBUG = 1
    INFO = 2
    WARN = 3
    ERROR = 4
    FATAL = 5


# rosgraph_msgs/Log has powers of two, rcl_interfaces/msg/Log tens.
_SEVERITIES = dict(zip((1, 2, 4, 8, 16), Severity, strict=True)) | dict(
    zip((10, 20, 30, 40, 50), Severity, strict=True)
)


class LogLine(Struct, frozen=True):
    """A line of /rosout received at `at` (monotonic seconds); `level` is ROS 1's or ROS 2's number, `stamp`
    the Unix second at which its node wrote it, by its own clock."""

    at: float
    level: int
    node: str
    text: str
    stamp: float | None = None

    @property
    def severity(self) -> Severity | None:
        """Return the severity, None for a number that neither ROS defines."""
        return _SEVERITIES.get(self.level)


class Health(IntEnum):
    """Levels of diagnostic_msgs/DiagnosticStatus, the same in ROS 1 and 2."""

    OK = 0
    WARN = 1
    ERROR = 2
    STALE = 3


class PartDiagnosis(Struct, frozen=True):
    """The diagnosis of one part by /diagnostics at `at` (monotonic seconds); `level` as `Health` has it."""

    at: float
    name: str
    level: int
    message: str
    hardware: str = ""
    values: tuple[tuple[str, str], ...] = ()
    """Measured values by name."""


# Nav2's `Goal failed error_code:105 error_msg:Failed to make progress.`
_CODED = re.compile(r"error_code:\s*(?P<code>\d+)\s+error_msg:\s*(?P<text>.*\w)")


def plain(text: str) -> str:
    """Return a line of the log as one says it: the message first, then its code."""
    coded = _CODED.search(text)
    return (
        Message("{text} (error {code})", text=coded["text"], code=coded["code"])
        if coded
        else text.strip().rstrip(".")
    )


_OF_BRIDGE = re.compile(r"(?:^|[/.])(?:rosbridge|rosapi)\w*$")
_OF_NAVIGATION = re.compile(
    r"(?:^|[/.])(?:bt_navigator|controller_server|planner_server|behavior_server|lifecycle_manager)\w*$"
)
_FOLLOWS = re.compile(
    r"^Goal (?:failed|canceled)$|Aborting handle|Stopping the thread per request|in node halt"
    r"|missed its desired rate|checker was specified"
)
_CODE = re.compile(r" \(error \d+\)$")
_FIGURES = re.compile(r"\d[\d.]*")


def is_of_bridge(node: str) -> bool:
    """Tell whether a node is one of the bridge: what it logs, also about this console, is of no robot."""
    return _OF_BRIDGE.search(node) is not None


def tells_causes(line: LogLine) -> bool:
    """Tell whether a line may tell why a robot does not drive: an error of any node but the bridge's, of the
    servers of Nav2 also a warning, which is all that some of them write about an abort."""
    severity = line.severity or Severity.DEBUG
    is_enough = severity >= (Severity.WARN if _OF_NAVIGATION.search(line.node) else Severity.ERROR)
    return is_enough and not is_of_bridge(line.node) and not follows(line.text)


def follows(text: str) -> bool:
    """Tell whether a line only follows from others that tell the cause, or tells none."""
    return _FOLLOWS.search(plain(text)) is not None


def cause_of(text: str) -> str:
    """Return what lines of one cause have in common: nodes repeat it with other figures, or with a code."""
    return _FIGURES.sub("", _CODE.sub("", plain(text))).casefold()


def named(robots: Iterable[str]) -> re.Pattern[str]:
    """Return the expression for the name of one of these robots in that of a node or of a part, with what
    divides it from the rest."""
    names = sorted(map(re.escape, robots), key=len, reverse=True)
    return re.compile(rf"(?<!\w)({'|'.join(names)})(?!\w)[ :/]*")


def part_of(name: re.Pattern[str], text: str) -> str:
    """Return `drive` of `robot_0: drive` and of `/robot_0/drive`."""
    return name.sub("", text).strip("/.")
