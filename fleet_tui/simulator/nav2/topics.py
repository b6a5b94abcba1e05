"""The topics of robots with Nav2: what is said all the time, and what only on change."""

import time
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.nav2 import messages
from fleet_tui.simulator.nav2.navigation import Navigation
from fleet_tui.simulator.nav2.poses import FRAME
from fleet_tui.simulator.nav2.robot import Nav2Robot
from fleet_tui.simulator.nav2.world import Nav2World
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, uuid_of

Message = dict[str, Any]
Make = Callable[[float], Message]

AMCL, MONITOR = "geometry_msgs/PoseWithCovarianceStamped", "nav2_msgs/CollisionMonitorState"
STATUS = "action_msgs/GoalStatusArray"


def map_topics(world: Nav2World, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
    """The maps, loaded at this wall time; with several floors also where each robot is."""
    several = len(world.building.floors) > 1
    for floor in world.building.floors:
        value = messages.grid(floor, messages.header(dialect, loaded_at), dialect.time(loaded_at))
        payload = raw_payload(dialect, "nav_msgs/OccupancyGrid", loaded_at, value)
        name = f"/{floor.name}/map" if several else "/map"
        type_ = dialect.message_type("nav_msgs/OccupancyGrid")
        yield Topic(name, type_, partial(_same, payload), latched=True)
    for robot in world.robots.values() if several else ():
        payload = Payload({"data": robot.floor.name})
        type_ = dialect.message_type("std_msgs/String")
        yield Topic(f"/{robot.name}/floor", type_, partial(_same, payload), latched=True)


def steady_topics(navigation: Navigation, dialect: Dialect) -> Iterator[Topic]:
    """The topics on which one robot speaks all the time, or all the way."""
    robot = navigation.robot
    made = partial(_made, robot, dialect)

    def header(now: float, frame: str = FRAME) -> Message:
        return messages.header(dialect, now, frame)

    def odom(now: float) -> Message:
        return messages.odometry(robot, header(now, f"{robot.name}/odom"))

    yield made("odom", "nav_msgs/Odometry", odom, fast=True, due=lambda: robot.odometry)
    yield made(
        *("battery_state", "sensor_msgs/BatteryState"),
        lambda now: messages.battery(robot, header(now, "")),
        turns=2,
    )
    yield made(
        *("plan", "nav_msgs/Path"),
        lambda now: messages.path(robot, header(now)),
        turns=2,
        due=lambda: bool(robot.way),
    )
    for server in navigation.servers.values():
        yield made(
            *(f"{server.verb}/_action/feedback", f"{server.type}_FeedbackMessage"),
            partial(_feedback, navigation, server, dialect),
            fast=True,
            due=partial(_on_the_way, navigation, server),
        )


def _made(robot: Nav2Robot, dialect: Dialect, name: str, type_: str, make: Make, **more: Any) -> Topic:
    def payload(now: float) -> Payload:
        return raw_payload(dialect, type_, now, make(now))

    return Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot, **more)


def _on_the_way(navigation: Navigation, server: ActionServer) -> bool:
    return navigation.tells and bool(server.running)


def _feedback(navigation: Navigation, server: ActionServer, dialect: Dialect, now: float) -> Message:
    goal = server.running[-1]
    told = messages.feedback(navigation, server.verb, goal, messages.header(dialect, now))
    return {"goal_id": {"uuid": uuid_of(goal.id)}, "feedback": told}


class News:
    """The topics on which robots speak only on change, and their newest messages for late subscribers."""

    def __init__(self, world: Nav2World) -> None:
        self._world = world
        self._newest: dict[str, Payload] = {}
        self._held: dict[str, dict[str, Payload]] = {name: {} for name in world.robots}
        self._blocked = dict.fromkeys(world.robots, False)

    def topics(self, dialect: Dialect) -> Iterator[Topic]:
        """The topics; the collision monitor's is not latched."""
        for name, navigation in self._world.navigation.items():
            yield self._topic(f"/{name}/amcl_pose", dialect.message_type(AMCL), name)
            yield self._topic(f"/{name}/collision_monitor_state", dialect.message_type(MONITOR), name, False)
            for server in navigation.servers.values():
                yield self._topic(_status(server), dialect.message_type(STATUS), name, server=server)

    def take(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Everything that changed since the last look; of a robot that can't be heard the newest waits."""
        now = time.time()
        for name, navigation in self._world.navigation.items():
            news = list(self._of(name, navigation, dialect, now))
            self._newest.update(news)
            if navigation.robot.silence:
                self._held[name].update(news)
            else:
                yield from self._held[name].items()
                self._held[name].clear()
                yield from news

    def _of(
        self, name: str, navigation: Navigation, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        robot = navigation.robot
        amcl = f"/{name}/amcl_pose"
        if robot.localise() or amcl not in self._newest:
            header = messages.header(dialect, now)
            value = messages.localisation(robot.estimate, robot.variance, header)
            yield amcl, raw_payload(dialect, AMCL, now, value)
        if (robot.obstacle > 0.0) != self._blocked[name]:
            self._blocked[name] = not self._blocked[name]
            value = messages.collision(self._blocked[name])
            yield f"/{name}/collision_monitor_state", raw_payload(dialect, MONITOR, now, value)
        for server in navigation.servers.values():
            while server.reports:
                value = messages.statuses(server.reports.popleft())
                yield _status(server), raw_payload(dialect, STATUS, now, value)

    def _topic(
        self, name: str, type_: str, robot: str, latched: bool = True, server: ActionServer | None = None
    ) -> Topic:
        def newest() -> Iterable[Payload]:
            payload, gone = self._newest.get(name), server is not None and not server.alive
            return () if payload is None or gone or self._world.robots[robot].silence else (payload,)

        return Topic(name, type_, lambda _now: Payload({}), latched=latched, history=newest)


def _status(server: ActionServer) -> str:
    return f"{server.name}/_action/status"


def _same(payload: Payload, _now: float) -> Payload:
    return payload
