"""States of fleets as events: one message has all robots of a fleet."""

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import msgspec

from fleet_tui.model import events
from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.geometry import Pose
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.rmf.encoded import line_of, text_reader
from fleet_tui.robots.rmf.names import robot_name
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import check_finite
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message, message_of
from fleet_tui.text.limits import LONGEST_NAME, truncate

Read = Callable[[frozenset[str], object, float], Iterable[events.Event]]
"""Reads a message that arrived at a monotonic second: the events of these robots. Raises WireError."""
MODES = (
    Message("idle"),
    Message("charging"),
    Message("moving"),
    Message("paused"),
    Message("waiting"),
    Message("emergency"),
    Message("going home"),
    Message("docking"),
    Message("adapter error"),
    Message("cleaning"),
    Message("performing an action"),
    Message("action completed"),
)
"""Modes of rmf_fleet_msgs/RobotMode, by number."""
FULL = 101.0
MOST_ROBOTS = 1000
MOST_ISSUES = 20


class LocationMessage(msgspec.Struct, frozen=True):
    """rmf_fleet_msgs/Location: metres and radians, `t` by the clock of the robot's driver."""

    x: float
    y: float
    yaw: float
    level_name: str
    t: ros.Stamp = ros.Stamp()


class ModeMessage(msgspec.Struct, frozen=True):
    """rmf_fleet_msgs/RobotMode."""

    mode: int
    performing_action: str = ""


class MemberMessage(msgspec.Struct, frozen=True):
    """rmf_fleet_msgs/RobotState."""

    name: str
    location: LocationMessage
    mode: ModeMessage = ModeMessage(0)
    battery_percent: float | None = None
    task_id: str = ""


class FleetMessage(msgspec.Struct, frozen=True):
    """rmf_fleet_msgs/FleetState, its robots unread: one bad one must not cost the others."""

    name: str
    robots: list[Any]


class PlaceUpdate(msgspec.Struct, frozen=True):
    """The location of a robot in fleet_state_update."""

    x: float
    y: float
    yaw: float
    map: str = ""


class MemberUpdate(msgspec.Struct, frozen=True):
    """A robot in fleet_state_update. `battery`: 0 to 1."""

    status: str = ""
    task_id: str = ""
    battery: float | None = None
    location: PlaceUpdate | None = None
    issues: list[Any] = []


class UpdatedFleet(msgspec.Struct, frozen=True):
    """The data of fleet_state_update, its robots unread: one bad one must not cost the others."""

    name: str
    robots: dict[str, Any] = {}


class FleetUpdate(msgspec.Struct, frozen=True):
    """fleet_state_update."""

    data: UpdatedFleet


def read_fleets() -> Read:
    """Read a rmf_fleet_msgs/FleetState."""
    read, read_one = ros.reader(FleetMessage), ros.reader(MemberMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        message, faults = read(msg), list[str]()
        for one in read_all(read_one, message.robots, Message("robots"), MOST_ROBOTS, faults):
            if (robot := robot_name(message.name, one.name)) in robots:
                yield _member(robot, one, at)
        if faults:
            raise WireError(f"fleet {truncate(message.name, LONGEST_NAME)}: {faults[0]}")

    return facts


def _member(robot: str, one: MemberMessage, at: float) -> events.Event:
    place, number = one.location, one.mode.mode
    mode = MODES[number] if 0 <= number < len(MODES) else Message("mode {number}", number=number)
    if number == MODES.index("performing an action") and one.mode.performing_action:
        mode = Message("performing {action}", action=truncate(one.mode.performing_action, LONGEST_NAME))
    try:
        pose, percent = _pose(place.x, place.y, place.yaw), _percent(one.battery_percent, 1.0)
    except WireError as problem:
        return events.MessageRejected(robot, message_of(problem))
    floor, task = truncate(place.level_name, LONGEST_NAME), truncate(one.task_id, LONGEST_NAME)
    return MemberReported(robot, at, pose, floor, place.t.seconds, percent, mode, task)


def _pose(x: float, y: float, yaw: float) -> Pose:
    check_finite(x, y, yaw, field="location")
    return Pose(x, y, math.remainder(yaw, math.tau))


def _percent(value: float | None, scale: float) -> float | None:
    if value is None or math.isnan(value):
        return None
    percent = value * scale
    if not 0.0 <= percent <= FULL:
        raise WireError(f"battery is {percent:g} %, not between 0 and 100")
    return percent


def read_statuses() -> Read:
    """Read a fleet_state_update."""
    read, read_one = text_reader(FleetUpdate), ros.reader(MemberUpdate)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        fleet = read(msg).data
        for name, one in fleet.robots.items():
            if (robot := robot_name(fleet.name, name)) in robots:
                try:
                    yield _status(robot, read_one(one), at)
                except WireError as problem:
                    yield events.MessageRejected(robot, message_of(problem))

    return facts


def _status(robot: str, one: MemberUpdate, at: float) -> events.Event:
    """Return the report of an adapter. Raises WireError."""
    place = one.location
    pose = _pose(place.x, place.y, place.yaw) if place else None
    percent = _percent(one.battery, 100.0)
    issues = tuple(filter(None, map(_issue, one.issues[:MOST_ISSUES])))
    status, task = truncate(one.status, LONGEST_NAME), truncate(one.task_id, LONGEST_NAME)
    floor = truncate(place.map, LONGEST_NAME) if place else ""
    return StatusReported(robot, at, status, task, issues, pose, floor, percent)


def _issue(value: Any) -> str:
    """Return an issue as `category: detail`."""
    if not isinstance(value, Mapping):
        return line_of(value)
    return ": ".join(filter(None, (line_of(value.get("category")), line_of(value.get("detail")))))
