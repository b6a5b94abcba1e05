"""Messages and topics of robots and floors."""

import math
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.ros.ros1 import ROS1
from fleet_tui.simulator.warehouse import SimFloor

if TYPE_CHECKING:
    from fleet_tui.simulator.fleets import Body

Message = dict[str, Any]


@dataclass(frozen=True)
class Topic:
    """A topic: `payload` makes its current message from the wall time in seconds since 1970.

    `robot` is the robot whose telemetry it is: published at the server's rate if `fast`, else twice a second,
    divided by `turns`. `due` tells whether there is a message now. Latched topics are sent once to every
    subscriber: the messages of `history`, or if that is None `payload`.
    """

    name: str
    type: str
    payload: Callable[[float], Payload]
    robot: "Body | None" = None
    fast: bool = False
    latched: bool = False
    history: Callable[[], Iterable[Payload]] | None = None
    turns: int = 1
    due: Callable[[], bool] | None = None


def topics_of(world: World, loaded_at: float, dialect: Dialect = ROS1) -> Iterator[Topic]:
    """Every topic of a world whose maps were loaded at this wall time."""
    for robot in world.robots.values():
        type_ = dialect.message_type("geometry_msgs/PoseStamped")
        yield Topic(f"/{robot.name}/pose", type_, _poses(robot, dialect), robot, fast=True)
        for name, (type_, message) in _TELEMETRY.items():
            payload = partial(_now, message, robot, dialect, type_)
            yield Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot)
    for floor in world.building.floors:
        for name, type_, value in (
            ("map_metadata", "nav_msgs/MapMetaData", _metadata(loaded_at, dialect)),
            ("graph", "OH_ressources/Graph", _graph(floor)),
            ("labeled_vertices", "OH_ressources/LabeledVertices", _labels(floor)),
            ("map", "nav_msgs/OccupancyGrid", _map(floor, loaded_at, dialect)),
        ):
            always = partial(_always, raw_payload(dialect, type_, loaded_at, value))
            for robot in world.robots.values():
                topic = f"/{robot.name}/{floor.name}/{name}"
                yield Topic(topic, dialect.message_type(type_), always, latched=True)


def raw_payload(dialect: Dialect, type_: str, now: float, value: Message) -> Payload:
    """A message that cbor-raw can carry too."""

    def raw(msg: Message) -> Message:
        short_name = dialect.short(dialect.message_type(type_))
        return {**dialect.time(now), "bytes": encode(dialect, short_name, msg)}

    return Payload(value, raw)


def float32(value: float) -> float:
    """Return a value rounded to float32."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


def _always(payload: Payload, _now: float) -> Payload:
    return payload


def _now(
    message: Callable[[SimRobot], Message], robot: SimRobot, dialect: Dialect, type_: str, now: float
) -> Payload:
    return raw_payload(dialect, type_, now, message(robot))


def _poses(robot: SimRobot, dialect: Dialect) -> Callable[[float], Payload]:
    said = count(1)

    def payload(now: float) -> Payload:
        pose = robot.belief.of(robot.pose)
        half = pose.yaw / 2.0
        header = dialect.header(next(said), now, robot.floor.name)
        position = {"x": pose.x, "y": pose.y, "z": 0.0}
        orientation = {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)}
        message = {"header": header, "pose": {"position": position, "orientation": orientation}}
        return raw_payload(dialect, "geometry_msgs/PoseStamped", now, message)

    return payload


def _battery(robot: SimRobot) -> Message:
    return {"data": float32(robot.battery)}


def _cargo(robot: SimRobot) -> Message:
    return {"data": robot.cargo}


def _obstacle(robot: SimRobot) -> Message:
    return {"data": float32(robot.obstacle)}


def _paused(robot: SimRobot) -> Message:
    return {"data": robot.paused}


def _queue(robot: SimRobot) -> Message:
    return {
        "request_id": robot.request_id,
        "last_order_id": robot.last_order_id,
        "robot_id": robot.index,
        "current_order_id": robot.current_order_id,
        "orders": [
            {"id": order.id, "start": order.start, "end": order.end, "status": order.status}
            for order in (*robot.ended, *robot.orders)
        ],
    }


_TELEMETRY: Mapping[str, tuple[str, Callable[[SimRobot], Message]]] = {
    "battery": ("std_msgs/Float32", _battery),
    "cargo": ("std_msgs/Bool", _cargo),
    "obstacle": ("std_msgs/Float32", _obstacle),
    "queue": ("OH_ressources/ActionQueue", _queue),
    "paused": ("std_msgs/Bool", _paused),
}


def _metadata(loaded_at: float, dialect: Dialect) -> Message:
    x, y = ORIGIN
    return {
        "map_load_time": dialect.time(loaded_at),
        "resolution": float32(RESOLUTION),
        "width": WIDTH,
        "height": HEIGHT,
        "origin": {
            "position": {"x": x, "y": y, "z": 0.0},
            "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0},
        },
    }


def _graph(floor: SimFloor) -> Message:
    return {
        "vertices": [
            {"id": vertex.id, "x": vertex.x, "y": vertex.y, "type": floor.types[vertex.id]}
            for vertex in floor.graph.vertices.values()
        ],
        "edges": [{"id": edge.id, "start": edge.start, "end": edge.end} for edge in floor.graph.edges],
    }


def _labels(floor: SimFloor) -> Message:
    return {"vertices": [{"label": label, "vertex_id": id_} for id_, label in floor.labels.items()]}


def _map(floor: SimFloor, loaded_at: float, dialect: Dialect) -> Message:
    header = dialect.header(1, loaded_at, floor.name)
    return {"header": header, "info": _metadata(loaded_at, dialect), "data": floor.cells.ravel()}
