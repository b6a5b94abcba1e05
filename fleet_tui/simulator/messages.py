"""What robots and floors say, as ROS messages, and the topics on which they say it."""

import math
import struct
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import Any

from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.robot import Robot
from fleet_tui.simulator.warehouse import Floor
from fleet_tui.simulator.world import World

Message = dict[str, Any]


@dataclass(frozen=True)
class Topic:
    """A topic: `payload` makes what is published now from the wall time in seconds since 1970.

    `robot` is whose telemetry it is: published at the server's rate where `fast`, else twice a second.
    Latched topics are said once to every subscriber.
    """

    name: str
    type: str
    payload: Callable[[float], Payload]
    robot: Robot | None = None
    fast: bool = False
    latched: bool = False


def topics_of(world: World, loaded_at: float) -> Iterator[Topic]:
    """Every topic of a world whose maps were loaded at this wall time."""
    for robot in world.robots.values():
        yield Topic(f"/{robot.name}/pose", "geometry_msgs/PoseStamped", _poses(robot), robot, fast=True)
        for name, (type_, message) in _TELEMETRY.items():
            yield Topic(f"/{robot.name}/{name}", type_, partial(_now, message, robot), robot)
    for floor in world.building.floors:
        for name, type_, value in (
            ("map_metadata", "nav_msgs/MapMetaData", _metadata(loaded_at)),
            ("graph", "OH_ressources/Graph", _graph(floor)),
            ("labeled_vertices", "OH_ressources/LabeledVertices", _labels(floor)),
            ("map", "nav_msgs/OccupancyGrid", _map(floor, loaded_at)),
        ):
            always = partial(_always, Payload(value))
            for robot in world.robots.values():
                yield Topic(f"/{robot.name}/{floor.name}/{name}", type_, always, latched=True)


def stamp(seconds: float) -> Message:
    """A ROS 1 time from seconds since 1970."""
    whole = math.floor(seconds)
    return {"secs": whole, "nsecs": int((seconds - whole) * 1e9)}


def float32(value: float) -> float:
    """The value as it looks after a float32 field."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


def _always(payload: Payload, _now: float) -> Payload:
    return payload


def _now(message: Callable[[Robot], Message], robot: Robot, _now: float) -> Payload:
    return Payload(message(robot))


def _poses(robot: Robot) -> Callable[[float], Payload]:
    said = count(1)

    def payload(now: float) -> Payload:
        half = robot.pose.yaw / 2.0
        header = {"seq": next(said), "stamp": stamp(now), "frame_id": robot.floor.name}
        position = {"x": robot.pose.x, "y": robot.pose.y, "z": 0.0}
        orientation = {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)}
        return Payload({"header": header, "pose": {"position": position, "orientation": orientation}})

    return payload


def _battery(robot: Robot) -> Message:
    return {"data": float32(robot.battery)}


def _cargo(robot: Robot) -> Message:
    return {"data": robot.cargo}


def _obstacle(robot: Robot) -> Message:
    return {"data": float32(robot.obstacle)}


def _paused(robot: Robot) -> Message:
    return {"data": robot.paused}


def _queue(robot: Robot) -> Message:
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


_TELEMETRY: Mapping[str, tuple[str, Callable[[Robot], Message]]] = {
    "battery": ("std_msgs/Float32", _battery),
    "cargo": ("std_msgs/Bool", _cargo),
    "obstacle": ("std_msgs/Float32", _obstacle),
    "queue": ("OH_ressources/ActionQueue", _queue),
    "paused": ("std_msgs/Bool", _paused),
}


def _metadata(loaded_at: float) -> Message:
    x, y = ORIGIN
    return {
        "map_load_time": stamp(loaded_at),
        "resolution": float32(RESOLUTION),
        "width": WIDTH,
        "height": HEIGHT,
        "origin": {
            "position": {"x": x, "y": y, "z": 0.0},
            "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0},
        },
    }


def _graph(floor: Floor) -> Message:
    return {
        "vertices": [
            {"id": vertex.id, "x": vertex.x, "y": vertex.y, "type": floor.types[vertex.id]}
            for vertex in floor.graph.vertices.values()
        ],
        "edges": [{"id": edge.id, "start": edge.start, "end": edge.end} for edge in floor.graph.edges],
    }


def _labels(floor: Floor) -> Message:
    return {"vertices": [{"label": label, "vertex_id": id_} for id_, label in floor.labels.items()]}


def _map(floor: Floor, loaded_at: float) -> Message:
    header = {"seq": 1, "stamp": stamp(loaded_at), "frame_id": floor.name}
    return {"header": header, "info": _metadata(loaded_at), "data": floor.cells.ravel()}
