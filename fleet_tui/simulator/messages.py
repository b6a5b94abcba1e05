"""Topics, and messages that several kinds of robots send."""

import math
import struct
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import count
from typing import Any

from fleet_tui.model.geometry import Pose, yaw_of_quaternion
from fleet_tui.simulator.floorplan import RESOLUTION, Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.world import Body

Message = dict[str, Any]
Header = Callable[[float], Message]
"""Makes the header of a topic's next message from the wall time."""

GRID = "nav_msgs/OccupancyGrid"
FRAME = "map"


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


def raw_payload(dialect: Dialect, type_: str, now: float, value: Message) -> Payload:
    """A message that cbor-raw can carry too."""

    def raw(msg: Message) -> Message:
        short_name = dialect.short(dialect.message_type(type_))
        return {**dialect.time(now), "bytes": encode(dialect, short_name, msg)}

    return Payload(value, raw)


def float32(value: float) -> float:
    """Return a value rounded to float32."""
    return float(struct.unpack("f", struct.pack("f", value))[0])


def headers(dialect: Dialect, frame: str = FRAME) -> Header:
    """The headers of one topic, in the map's frame or another."""
    sequence = count(1)
    return lambda now: dialect.header(next(sequence), now, frame)


def solid(pose: Pose) -> Message:
    """A pose in space: geometry_msgs/Pose."""
    half = pose.yaw / 2.0
    return {
        "position": {"x": pose.x, "y": pose.y, "z": 0.0},
        "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)},
    }


def stamped(pose: Pose) -> Message:
    """A pose on the map without a time: geometry_msgs/PoseStamped."""
    return {"header": {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": FRAME}, "pose": solid(pose)}


def flat(pose: Message) -> Pose:
    """A pose on the plane; a quaternion of zeros is no rotation."""
    turn = pose["orientation"]
    try:
        yaw = yaw_of_quaternion(turn["x"], turn["y"], turn["z"], turn["w"])
    except ValueError:
        yaw = 0.0
    return Pose(pose["position"]["x"], pose["position"]["y"], yaw)


def grid(cells: Cells, origin: tuple[float, float], header: Message, loaded: Message) -> Message:
    """nav_msgs/OccupancyGrid; `origin` is the place of its lower left corner."""
    return {"header": header, "info": grid_info(cells, origin, loaded), "data": cells.ravel()}


def grid_info(cells: Cells, origin: tuple[float, float], loaded: Message) -> Message:
    """nav_msgs/MapMetaData."""
    height, width = cells.shape
    return {
        "map_load_time": loaded,
        "resolution": float32(RESOLUTION),
        "width": width,
        "height": height,
        "origin": solid(Pose(*origin)),
    }
