"""The laser of a simulated robot: its beams end at the walls of the floor's own plan."""

import math
from collections.abc import Iterable, Iterator
from itertools import cycle
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import OCCUPIED, ORIGIN, RESOLUTION, Cells
from fleet_tui.simulator.frames import Floats, Payload
from fleet_tui.simulator.messages import Message, Topic, float32, headers, solid
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.warehouse import SimFloor
from fleet_tui.simulator.world import Body

BEAMS = 720
RANGE = 12.0  # metres
NEAREST = 0.1  # metres
SCAN = "sensor_msgs/LaserScan"
MOUNT = Pose(0.2, 0.05, math.pi / 18)
"""Its place on every robot: left of the middle of the front, turned to the left."""
STATIC_FRAMES = "/tf_static"
TRANSFORMS = "tf2_msgs/TFMessage"

_ANGLES = -math.pi + 2.0 * math.pi / BEAMS * np.arange(BEAMS)
_STEPS = np.arange(NEAREST, RANGE, RESOLUTION)


class Surveyor(Body, Protocol):
    """A robot with senses."""

    pose: Pose

    @property
    def floor(self) -> SimFloor: ...


def cells_along(
    cells: Cells, pose: Pose, angles: NDArray[np.floating], steps: NDArray[np.floating]
) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.bool_]]:
    """Return rows and columns of the cells at each step (metres) of each beam and whether they are walls,
    each of shape (angles, steps). Beyond the floor its last cell counts."""
    shares = np.outer(np.sin(angles), steps), np.outer(np.cos(angles), steps)
    starts = pose.y - ORIGIN[1], pose.x - ORIGIN[0]
    for metres, start, count in zip(shares, starts, cells.shape, strict=True):
        # In place: a simulated fleet casts thousands of beams a second, and fresh pages are half the cost.
        metres += start
        metres /= RESOLUTION
        np.clip(metres, 0, count - 1, out=metres)
    rows, columns = (metres.astype(np.int32) for metres in shares)
    return rows, columns, cells[rows, columns] == OCCUPIED


def ends(cells: Cells, pose: Pose) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.intp]]:
    """Return rows and columns of the cells along every beam, shape (BEAMS, steps), and the step at which each
    beam ends: the number of steps for one that hits nothing."""
    rows, columns, hits = cells_along(cells, pose, _ANGLES + pose.yaw, _STEPS)
    return rows, columns, np.where(hits.any(axis=1), hits.argmax(axis=1), len(_STEPS))


def ranges(cells: Cells, pose: Pose) -> NDArray[np.float32]:
    """Return the range of each beam in metres, infinite for one that hits nothing."""
    _, _, first = ends(cells, pose)
    return np.append(_STEPS, np.inf)[first].astype(np.float32)


def scan(cells: Cells, pose: Pose, header: Message) -> Payload:
    """sensor_msgs/LaserScan at a pose."""
    step = 2.0 * math.pi / BEAMS
    return Payload(
        {
            "header": header,
            "angle_min": float32(-math.pi),
            "angle_max": float32(-math.pi + step * (BEAMS - 1)),
            "angle_increment": float32(step),
            "time_increment": 0.0,
            "scan_time": float32(0.2),
            "range_min": float32(NEAREST),
            "range_max": float32(RANGE),
            "ranges": Floats(ranges(cells, pose)),
            "intensities": Floats(np.zeros(0, dtype=np.float32)),
        }
    )


def scan_topic(robot: Surveyor, dialect: Dialect) -> Topic:
    """The scans of a robot, five a second at the usual rate: from its true pose and the place of its laser,
    wherever it believes to be."""
    header = headers(dialect, f"{robot.name}/laser")

    def payload(now: float) -> Payload:
        return scan(robot.floor.cells, robot.pose.after(MOUNT), header(now))

    turns: Iterator[bool] = cycle((True, False))
    type_ = dialect.message_type(SCAN)
    return Topic(f"/{robot.name}/scan", type_, payload, robot, fast=True, due=lambda: next(turns))


def frames_topic(robots: Iterable[str], loaded_at: float, dialect: Dialect) -> Topic:
    """The static frames of all robots, up to the laser. Each has its own publisher, whose message late
    subscribers get."""
    payloads = [Payload({"transforms": list(_frames(robot, loaded_at, dialect))}) for robot in robots]
    nothing = Payload({"transforms": []})
    type_ = dialect.message_type(TRANSFORMS)
    return Topic(STATIC_FRAMES, type_, lambda _: nothing, latched=True, history=lambda: payloads)


def _frames(robot: str, at: float, dialect: Dialect) -> Iterator[Message]:
    for parent, child, pose, height in (
        ("base_footprint", "base_link", Pose(0.0, 0.0), 0.1),
        ("base_link", "laser", MOUNT, 0.25),
    ):
        yield {
            "header": dialect.header(0, at, f"{robot}/{parent}"),
            "child_frame_id": f"{robot}/{child}",
            "transform": {
                "translation": {"x": pose.x, "y": pose.y, "z": height},
                "rotation": solid(pose)["orientation"],
            },
        }
