"""The topics of robots that navigate: maps, and the continuous topics of one robot."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Protocol

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.navigating import messages
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.warehouse import Building

Message = dict[str, Any]


class Make(Protocol):
    """Makes a topic of one robot: `make` makes its messages from the wall time, `more` is Topic's."""

    def __call__(self, name: str, type_: str, make: Callable[[float], Message], **more: Any) -> Topic:
        """Make it."""


def map_topics(
    building: Building, robots: dict[str, NavigatingRobot], loaded_at: float, dialect: Dialect
) -> Iterator[Topic]:
    """The maps, loaded at this wall time; with several floors also where each robot is."""
    several = len(building.floors) > 1
    for floor in building.floors:
        header = messages.headers(dialect)(loaded_at)
        value = messages.grid(floor, header, dialect.time(loaded_at))
        payload = raw_payload(dialect, "nav_msgs/OccupancyGrid", loaded_at, value)
        name = f"/{floor.name}/map" if several else "/map"
        type_ = dialect.message_type("nav_msgs/OccupancyGrid")
        yield Topic(name, type_, partial(_same, payload), latched=True)
    for robot in robots.values() if several else ():
        payload = Payload({"data": robot.floor.name})
        type_ = dialect.message_type("std_msgs/String")
        yield Topic(f"/{robot.name}/floor", type_, partial(_same, payload), latched=True)


def topic_maker(robot: NavigatingRobot, dialect: Dialect) -> Make:
    """Makes the topics of one robot."""

    def topic(name: str, type_: str, make: Callable[[float], Message], **more: Any) -> Topic:
        def payload(now: float) -> Payload:
            return raw_payload(dialect, type_, now, make(now))

        return Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot, **more)

    return topic


def body_topics(robot: NavigatingRobot, dialect: Dialect) -> Iterator[Topic]:
    """Odometry and battery."""
    topic = topic_maker(robot, dialect)
    wheels, charge = messages.headers(dialect, f"{robot.name}/odom"), messages.headers(dialect, "")
    yield topic(
        *("odom", "nav_msgs/Odometry"),
        lambda now: messages.odometry(robot, dialect, wheels(now)),
        fast=True,
        due=lambda: robot.odometry,
    )
    yield topic(
        *("battery_state", "sensor_msgs/BatteryState"),
        lambda now: messages.battery(robot, charge(now)),
        turns=2,
    )


def plan_topic(robot: NavigatingRobot, dialect: Dialect, name: str) -> Topic:
    """The path that a robot follows."""
    header = messages.headers(dialect)
    return topic_maker(robot, dialect)(
        *(name, "nav_msgs/Path"),
        lambda now: messages.path(robot, header(now)),
        turns=2,
        due=lambda: bool(robot.way),
    )


def _same(payload: Payload, _now: float) -> Payload:
    return payload
