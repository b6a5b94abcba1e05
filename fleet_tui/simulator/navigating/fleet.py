"""Robots that navigate on the wire: their bodies, maps and modes, and their set-up."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from itertools import count
from typing import Any

from fleet_tui.simulator.fleets import Fleet, Subscriptions
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import BROKEN, DOUBTFUL, HEALTHY, entry
from fleet_tui.simulator.messages import FRAME, GRID, Message, Topic, flat, grid, headers, raw_payload
from fleet_tui.simulator.navigating import messages
from fleet_tui.simulator.navigating.robot import LOST, NavigatingRobot
from fleet_tui.simulator.navigating.world import N, NavigatingWorld, NewStack
from fleet_tui.simulator.robot import EMPTY, LOW
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type
from fleet_tui.simulator.senses.camera import camera_topic
from fleet_tui.simulator.senses.laser import scan_topic
from fleet_tui.simulator.senses.mapping import Surveys
from fleet_tui.simulator.senses.wheels import twists
from fleet_tui.simulator.warehouse import SimFloor

AMCL = "geometry_msgs/PoseWithCovarianceStamped"
SETTLE = "request_nomotion_update"
UNIT = 0.01
"""Deviation of a quaternion from unit length above which it is dropped."""

FileServices = Mapping[str, tuple[str, Message | Callable[[str, Mapping[str, Any]], Message]]]
"""Services about files by the last part of their names: the type, and the answer, or what gives it from the
name of a robot and a request."""


class NavigatingFleet(NavigatingWorld[N], Fleet):
    """The robots of a world on the wire. A kind adds what its navigation stack publishes and accepts."""

    robots: dict[str, NavigatingRobot]
    localise_service: str
    """The last part of the name of the service of global localisation."""
    mapping_service: str
    """The same of the switch of mapping, which is on after a call with False."""
    file_services: FileServices

    def __init__(
        self,
        stack: NewStack[N],
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        step: int = 1,
    ) -> None:
        super().__init__(stack, robots, floors, seed, quiet, first, step, time.time_ns)
        self._surveys = Surveys(self.robots, lambda floor: [self._map_topic(floor)])
        self.troubles.append(self._surveys.step)
        self._newest: dict[str, Payload] = {}
        self._held: dict[str, dict[str, Payload]] = {name: {} for name in self.robots}
        self._places = {name: count(1) for name in self.robots}

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        yield from self._map_topics(loaded_at, dialect)
        yield from self._surveys.topics(dialect)
        for navigation in self.navigation.values():
            yield from body_topics(navigation.robot, dialect)
            yield from self.stack_topics(navigation, dialect)
        for name in self.robots:
            yield self.topic_on_change(name, "amcl_pose", AMCL, dialect)

    def stack_topics(self, navigation: N, dialect: Dialect) -> Iterable[Topic]:
        """The topics that a robot's navigation stack publishes continuously, or while it drives."""
        return ()

    def changes(
        self, name: str, navigation: N, dialect: Dialect, now: float
    ) -> Iterable[tuple[str, Payload]]:
        """Return the changes of a robot's navigation stack since the last call."""
        return ()

    def topic_on_change(
        self,
        robot: str,
        name: str,
        type_: str,
        dialect: Dialect,
        latched: bool = True,
        alive: Callable[[], bool] | None = None,
    ) -> Topic:
        """A topic of one robot; a latched value exists while its publisher is `alive`."""
        name = f"/{robot}/{name}"

        def newest() -> Iterable[Payload]:
            payload, gone = self._newest.get(name), alive is not None and not alive()
            return () if payload is None or gone or self.robots[robot].silence else (payload,)

        type_ = dialect.message_type(type_)
        return Topic(name, type_, lambda _now: Payload({}), latched=latched, history=newest)

    def news(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return all changes since the last call; for a silent robot the newest is kept until it is no longer
        silent."""
        now = time.time()
        for name, navigation in self.navigation.items():
            news = [
                *self._place(name, navigation.robot, dialect, now),
                *self.changes(name, navigation, dialect, now),
            ]
            self._newest.update(news)
            if navigation.robot.silence:
                self._held[name].update(news)
            else:
                yield from self._held[name].items()
                self._held[name].clear()
                yield from news
        yield from self._surveys.news(self._grids(now, dialect))

    def _place(
        self, name: str, robot: NavigatingRobot, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        amcl = f"/{name}/amcl_pose"
        if robot.localise() or (amcl not in self._newest and not robot.is_lost_at_start):
            header = dialect.header(next(self._places[name]), now, FRAME)
            value = messages.localisation(robot.estimate, robot.variance, dialect, header)
            yield amcl, raw_payload(dialect, AMCL, now, value)

    def _map_topic(self, floor: SimFloor) -> str:
        return f"/{floor.name}/map" if len(self.building.floors) > 1 else "/map"

    def _map_topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """The maps; with several floors also where each robot is."""
        for floor in self.building.floors:
            value = self._grids(loaded_at, dialect)(floor)
            payload = raw_payload(dialect, GRID, loaded_at, value)
            name, newest = self._map_topic(floor), partial(self._map, floor, payload, dialect, loaded_at)
            yield Topic(name, dialect.message_type(GRID), newest, latched=True)
            if dialect.version == 1:  # the map_server of Nav2 publishes none
                info = Payload(value["info"])
                yield Topic(f"{name}_metadata", "nav_msgs/MapMetaData", partial(_same, info), latched=True)
        for robot in self.robots.values() if len(self.building.floors) > 1 else ():
            payload = Payload({"data": robot.floor.name})
            type_ = dialect.message_type("std_msgs/String")
            yield Topic(f"/{robot.name}/floor", type_, partial(_same, payload), latched=True)

    def _map(
        self, floor: SimFloor, loaded: Payload, dialect: Dialect, loaded_at: float, _now: float
    ) -> Payload:
        """Return the map that was loaded until a robot maps the floor again."""
        if self._surveys.cells(floor)[0] is floor.cells:
            return loaded
        return Payload(self._grids(loaded_at, dialect)(floor))

    def _grids(self, at: float, dialect: Dialect) -> Callable[[SimFloor], Message]:
        """Return a function that makes the present map of a floor."""
        header = headers(dialect)
        return lambda floor: grid(*self._surveys.cells(floor), header(at), dialect.time(at))

    def subscriptions(self) -> Subscriptions:
        """The topics of each robot on which its pose is set, and on which it is driven."""
        poses = {f"/{name}/initialpose": (AMCL, partial(_take, robot)) for name, robot in self.robots.items()}
        return poses | twists(self.robots)

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        parts = {
            self.localise_service: "std_srvs/Empty",
            SETTLE: "std_srvs/Empty",
            self.mapping_service: "std_srvs/SetBool",
        } | {part: type_ for part, (type_, _) in self.file_services.items()}
        types = {part: service_type(dialect, name) for part, name in parts.items()}
        return {f"/{name}/{part}": type_ for name in self.robots for part, type_ in types.items()}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        name, _, part = service.removeprefix("/").partition("/")
        robot = self.robots[name]
        if part == self.mapping_service:
            self._surveys.switch(name, on=not args["data"])
            return {"success": True, "message": ""}
        if part in self.file_services:
            answer = self.file_services[part][1]
            return answer(name, args) if callable(answer) else dict(answer)
        robot.place(robot.pose if part == self.localise_service else robot.belief.of(robot.pose))
        return {}

    def health(self) -> Iterator[Message]:
        """Return battery and localisation of every robot that is not silent, and what its stack adds."""
        for name, navigation in self.navigation.items():
            if not navigation.robot.silence:
                yield from health(navigation.robot)
                yield from self.stack_health(name, navigation)

    def stack_health(self, name: str, navigation: N) -> Iterable[Message]:
        """Return what a robot's navigation stack publishes on /diagnostics."""
        return ()


def robot_topic(
    robot: NavigatingRobot,
    dialect: Dialect,
    name: str,
    type_: str,
    make: Callable[[float], Message],
    **more: Any,
) -> Topic:
    """A topic of one robot: `make` makes its messages from the wall time, `more` is Topic's."""

    def payload(now: float) -> Payload:
        return raw_payload(dialect, type_, now, make(now))

    return Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot, **more)


def body_topics(robot: NavigatingRobot, dialect: Dialect) -> Iterator[Topic]:
    """Odometry, laser, camera and battery."""
    wheels, charge = headers(dialect, f"{robot.name}/odom"), headers(dialect, "")
    yield robot_topic(
        robot,
        dialect,
        "odom",
        "nav_msgs/Odometry",
        lambda now: messages.odometry(robot, dialect, wheels(now)),
        fast=True,
        due=lambda: robot.odometry,
    )
    yield scan_topic(robot, dialect)
    yield camera_topic(robot, dialect)
    yield robot_topic(
        robot,
        dialect,
        "battery_state",
        "sensor_msgs/BatteryState",
        lambda now: messages.battery(robot, charge(now)),
        turns=2,
    )


def plan_topic(robot: NavigatingRobot, dialect: Dialect, name: str) -> Topic:
    """The path that a robot follows."""
    header = headers(dialect)
    return robot_topic(
        robot,
        dialect,
        name,
        "nav_msgs/Path",
        lambda now: messages.path(robot, header(now)),
        turns=2,
        due=lambda: bool(robot.way),
    )


def health(robot: NavigatingRobot) -> Iterator[Message]:
    """The entries of /diagnostics about one robot."""
    empty, low = robot.battery < EMPTY, robot.battery < LOW
    level = BROKEN if empty else DOUBTFUL if low else HEALTHY
    message = "empty" if empty else "low" if low else "charging" if robot.docked else "charged"
    yield entry(robot, "battery", level, message, percent=f"{robot.battery:.1f}")
    lost = robot.variance >= LOST
    level, message = (DOUBTFUL, "not sure where it is") if lost else (HEALTHY, "localised")
    yield entry(robot, "localisation", level, message, variance=f"{robot.variance:g}")


def _take(robot: NavigatingRobot, message: Message) -> None:
    """Take a pose, as amcl does: one in a foreign frame, or without a rotation, is dropped silently."""
    pose = message["pose"]["pose"]
    length = sum(pose["orientation"][axis] ** 2 for axis in "xyzw")
    if message["header"]["frame_id"].lstrip("/") == FRAME and abs(length - 1.0) < UNIT:
        robot.place(flat(pose))


def _same(payload: Payload, _now: float) -> Payload:
    return payload
