"""The topics of robots that navigate: maps, and the continuous topics of one robot."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Protocol

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.navigating import messages
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.senses.camera import camera_topic
from fleet_tui.simulator.senses.laser import scan_topic
from fleet_tui.simulator.senses.mapping import Surveys
from fleet_tui.simulator.warehouse import Building, SimFloor

MAP = "nav_msgs/OccupancyGrid"
METADATA = "nav_msgs/MapMetaData"

Message = dict[str, Any]


class Make(Protocol):
    """Makes a topic of one robot: `make` makes its messages from the wall time, `more` is Topic's."""

    def __call__(self, name: str, type_: str, make: Callable[[float], Message], **more: Any) -> Topic: ...


def map_topics(
    building: Building,
    robots: dict[str, NavigatingRobot],
    surveys: Surveys,
    loaded_at: float,
    dialect: Dialect,
) -> Iterator[Topic]:
    """The maps, loaded at this wall time; with several floors also where each robot is."""
    several = len(building.floors) > 1
    for floor in building.floors:
        value = grid_of(surveys, loaded_at, dialect)(floor)
        payload = raw_payload(dialect, MAP, loaded_at, value)
        newest = partial(_newest, floor, surveys, payload, dialect, loaded_at)
        name = map_topic(building, floor)
        yield Topic(name, dialect.message_type(MAP), newest, latched=True)
        if dialect.version == 1:  # the map_server of Nav2 publishes none
            info = Payload(value["info"])
            yield Topic(f"{name}_metadata", METADATA, partial(_same, info), latched=True)
    for robot in robots.values() if several else ():
        payload = Payload({"data": robot.floor.name})
        type_ = dialect.message_type("std_msgs/String")
        yield Topic(f"/{robot.name}/floor", type_, partial(_same, payload), latched=True)


def map_topic(building: Building, floor: SimFloor) -> str:
    """The name of the topic with the map of a floor."""
    return f"/{floor.name}/map" if len(building.floors) > 1 else "/map"


def grid_of(surveys: Surveys, loaded_at: float, dialect: Dialect) -> Callable[[SimFloor], Message]:
    """Makes the present map of a floor."""
    header = messages.headers(dialect)

    def grid(floor: SimFloor) -> Message:
        return messages.grid(*surveys.cells(floor), header(loaded_at), dialect.time(loaded_at))

    return grid


def _newest(
    floor: SimFloor, surveys: Surveys, loaded: Payload, dialect: Dialect, loaded_at: float, _now: float
) -> Payload:
    """Return the map that was loaded until a robot maps the floor again."""
    if surveys.cells(floor)[0] is floor.cells:
        return loaded
    return Payload(grid_of(surveys, loaded_at, dialect)(floor))


def topic_maker(robot: NavigatingRobot, dialect: Dialect) -> Make:
    def topic(name: str, type_: str, make: Callable[[float], Message], **more: Any) -> Topic:
        def payload(now: float) -> Payload:
            return raw_payload(dialect, type_, now, make(now))

        return Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot, **more)

    return topic


def body_topics(robot: NavigatingRobot, dialect: Dialect) -> Iterator[Topic]:
    """Odometry, battery and laser."""
    topic = topic_maker(robot, dialect)
    wheels, charge = messages.headers(dialect, f"{robot.name}/odom"), messages.headers(dialect, "")
    yield topic(
        "odom",
        "nav_msgs/Odometry",
        lambda now: messages.odometry(robot, dialect, wheels(now)),
        fast=True,
        due=lambda: robot.odometry,
    )
    laser = messages.headers(dialect, f"{robot.name}/laser")
    yield scan_topic(robot, lambda: robot.floor.cells, laser, dialect)
    lens = messages.headers(dialect, f"{robot.name}/camera")
    yield camera_topic(robot, lambda: robot.floor.cells, lens, dialect)
    yield topic(
        "battery_state", "sensor_msgs/BatteryState", lambda now: messages.battery(robot, charge(now)), turns=2
    )


def plan_topic(robot: NavigatingRobot, dialect: Dialect, name: str) -> Topic:
    """The path that a robot follows."""
    header = messages.headers(dialect)
    return topic_maker(robot, dialect)(
        name,
        "nav_msgs/Path",
        lambda now: messages.path(robot, header(now)),
        turns=2,
        due=lambda: bool(robot.way),
    )


def _same(payload: Payload, _now: float) -> Payload:
    return payload
