"""Set-up of robots that navigate: poses set from outside, localisation, mapping."""

import time
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.navigating.poses import FRAME, flat
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.navigating.topics import grid_of, map_topic, map_topics
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type
from fleet_tui.simulator.senses.mapping import Surveys
from fleet_tui.simulator.senses.wheels import twists

Message = dict[str, Any]
Subscriptions = dict[str, tuple[str, Callable[[Message], None]]]
FileServices = Mapping[str, tuple[str, Message | Callable[[str, Mapping[str, Any]], Message]]]
"""Services about files by the last part of their names: the type, and the answer, or what gives it from the
name of a robot and a request."""
NO_FILES: FileServices = {}
POSE = "geometry_msgs/PoseWithCovarianceStamped"
SETTLE = "request_nomotion_update"
UNIT = 0.01
"""Deviation of a quaternion from unit length above which it is dropped."""


def by_hand(robots: Mapping[str, NavigatingRobot]) -> Subscriptions:
    """Return the topics of each robot on which its pose is set, and on which it is driven."""
    poses = {f"/{name}/initialpose": (POSE, partial(_take, robot)) for name, robot in robots.items()}
    return poses | twists(robots)


class SetUpDesk:
    """The set-up of a fleet's robots: their maps, modes and services. `localise` and `switch` are the last
    parts of the names of services: global localisation, and mapping, which is on after a call with False.
    `files`: the services that save or load files."""

    def __init__(
        self, world: NavigatingWorld[Any], localise: str, switch: str, files: FileServices = NO_FILES
    ) -> None:
        self._robots = world.robots
        self._building = world.building
        self._localise = localise
        self._switch = switch
        self._files = files
        self.surveys = Surveys(world.robots, lambda floor: [map_topic(world.building, floor)])
        world.troubles.append(self.surveys.step)

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Return maps and modes; the maps were loaded at this wall time."""
        yield from map_topics(self._building, self._robots, self.surveys, loaded_at, dialect)
        yield from self.surveys.topics(dialect)

    def news(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return the maps and modes that changed since the last call."""
        return self.surveys.news(grid_of(self.surveys, time.time(), dialect))

    def services(self, dialect: Dialect) -> dict[str, ServiceType]:
        """Return every service with its type."""
        empty, switch = (service_type(dialect, f"std_srvs/{name}") for name in ("Empty", "SetBool"))
        parts = {self._localise: empty, SETTLE: empty, self._switch: switch}
        parts |= {part: service_type(dialect, type_) for part, (type_, _) in self._files.items()}
        return {f"/{name}/{part}": type_ for name in self._robots for part, type_ in parts.items()}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message | None:
        """Carry out a call; None if the service is another one."""
        name, _, part = service.removeprefix("/").partition("/")
        robot = self._robots[name]
        if part == self._switch:
            self.surveys.switch(name, on=not args["data"])
            return {"success": True, "message": ""}
        if part in self._files:
            answer = self._files[part][1]
            return answer(name, args) if callable(answer) else dict(answer)
        if part not in (self._localise, SETTLE):
            return None
        robot.place(robot.pose if part == self._localise else robot.belief.of(robot.pose))
        return {}


def _take(robot: NavigatingRobot, message: Message) -> None:
    """Take a pose, as amcl does: one in a foreign frame, or without a rotation, is dropped silently."""
    pose = message["pose"]["pose"]
    length = sum(pose["orientation"][axis] ** 2 for axis in "xyzw")
    if message["header"]["frame_id"].lstrip("/") == FRAME and abs(length - 1.0) < UNIT:
        robot.place(flat(pose))
