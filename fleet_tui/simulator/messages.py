"""Messages and topics of robots and floors."""

import math
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import count
from typing import Any, Protocol

from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH, Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.senses.wheels import Wheels
from fleet_tui.simulator.warehouse import SimFloor

Message = dict[str, Any]


class Body(Protocol):
    """A robot of any kind."""

    name: str
    index: int
    silence: float
    """Seconds for which none of the robot's topics are published."""
    wheels: Wheels


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
    robot: Body | None = None
    fast: bool = False
    latched: bool = False
    history: Callable[[], Iterable[Payload]] | None = None
    turns: int = 1
    due: Callable[[], bool] | None = None


CellsOf = Callable[[SimFloor], tuple[Cells, tuple[float, float]]]
"""Returns the cells of a floor's map, and the place of its lower left corner."""


def _whole(floor: SimFloor) -> tuple[Cells, tuple[float, float]]:
    return floor.cells, ORIGIN


def topics_of(
    world: World, loaded_at: float, dialect: Dialect = ROS1, cells: CellsOf = _whole
) -> Iterator[Topic]:
    """Every topic of a world whose maps were loaded at this wall time."""
    for robot in world.robots.values():
        type_ = dialect.message_type("geometry_msgs/PoseStamped")
        yield Topic(f"/{robot.name}/pose", type_, _poses(robot, dialect), robot, fast=True)
        for name, (type_, message) in _TELEMETRY.items():
            payload = partial(_now, message, robot, dialect, type_)
            yield Topic(f"/{robot.name}/{name}", dialect.message_type(type_), payload, robot)
    for number, floor in enumerate(world.building.floors):
        for name, type_, value in (
            ("map_metadata", "nav_msgs/MapMetaData", lambda _floor: _metadata(loaded_at, dialect)),
            ("graph", "OH_ressources/Graph", graph_of),
            ("labeled_vertices", "OH_ressources/LabeledVertices", labels_of),
        ):
            always = _of_floor(world, number, partial(_loaded, value, type_, loaded_at, dialect))
            for robot in world.robots.values():
                topic = f"/{robot.name}/{floor.name}/{name}"
                yield Topic(topic, dialect.message_type(type_), always, latched=True)
        yield from _maps(world, floor, loaded_at, dialect, cells)


def _loaded(
    value: Callable[[SimFloor], Message], type_: str, at: float, dialect: Dialect, floor: SimFloor
) -> Payload:
    return raw_payload(dialect, type_, at, value(floor))


def _of_floor(
    world: World, number: int, payload: Callable[[SimFloor], Payload]
) -> Callable[[float], Payload]:
    """The message of a floor, one for all robots and all subscribers until the floor is redrawn."""
    made = lru_cache(maxsize=1)(payload)
    return lambda _now: made(world.building.floors[number])


def _maps(
    world: World, floor: SimFloor, loaded_at: float, dialect: Dialect, cells: CellsOf
) -> Iterator[Topic]:
    type_ = "nav_msgs/OccupancyGrid"
    loaded = raw_payload(dialect, type_, loaded_at, map_of(floor, loaded_at, dialect, cells))

    def payload(now: float) -> Payload:
        is_loaded = cells(floor)[0] is floor.cells
        return loaded if is_loaded else Payload(map_of(floor, now, dialect, cells))

    for robot in world.robots.values():
        yield Topic(f"/{robot.name}/{floor.name}/map", dialect.message_type(type_), payload, latched=True)


def headers_of(robot: SimRobot, dialect: Dialect, frame: str = "laser") -> Callable[[float], Message]:
    """The headers of the scans, or the pictures, of a robot."""
    said = count(1)
    return lambda now: dialect.header(next(said), now, f"{robot.name}/{frame}")


def raw_payload(dialect: Dialect, type_: str, now: float, value: Message) -> Payload:
    """A message that cbor-raw can carry too."""

    def raw(msg: Message) -> Message:
        short_name = dialect.short(dialect.message_type(type_))
        return {**dialect.time(now), "bytes": encode(dialect, short_name, msg)}

    return Payload(value, raw)


def float32(value: float) -> float:
    """Return a value rounded to float32."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


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


def _metadata(
    loaded_at: float,
    dialect: Dialect,
    origin: tuple[float, float] = ORIGIN,
    shape: tuple[int, ...] = (HEIGHT, WIDTH),
) -> Message:
    x, y = origin
    return {
        "map_load_time": dialect.time(loaded_at),
        "resolution": float32(RESOLUTION),
        "width": shape[1],
        "height": shape[0],
        "origin": {
            "position": {"x": x, "y": y, "z": 0.0},
            "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0},
        },
    }


def graph_of(floor: SimFloor) -> Message:
    """OH_ressources/Graph."""
    return {
        "vertices": [
            {"id": vertex.id, "x": vertex.x, "y": vertex.y, "type": floor.types[vertex.id]}
            for vertex in floor.graph.vertices.values()
        ],
        "edges": [{"id": edge.id, "start": edge.start, "end": edge.end} for edge in floor.graph.edges],
    }


def labels_of(floor: SimFloor) -> Message:
    """OH_ressources/LabeledVertices."""
    return {"vertices": [{"label": label, "vertex_id": id_} for id_, label in floor.labels.items()]}


def map_of(floor: SimFloor, at: float, dialect: Dialect, cells: CellsOf) -> Message:
    """nav_msgs/OccupancyGrid, as a robot knows a floor now."""
    known, origin = cells(floor)
    info = _metadata(at, dialect, origin, known.shape)
    return {"header": dialect.header(1, at, floor.name), "info": info, "data": known.ravel()}
