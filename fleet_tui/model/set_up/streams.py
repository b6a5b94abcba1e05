"""Streams of a robot, beside the fleet state: laser scans, planned paths, camera pictures. With numpy."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.frames import Frames
from fleet_tui.text.language import EMPTY, Message

Points = NDArray[np.float32]
"""Shape (n, 2): x and y in metres."""


@dataclass(frozen=True, eq=False, slots=True)
class LaserScan:
    """A scan as the laser sends it: the range of each beam in metres, its angles in radians. `stamp` is the
    robot's own clock in seconds, None if it gives none."""

    ranges: NDArray[np.float32]
    angle_min: float
    angle_increment: float
    range_min: float
    range_max: float
    frame_id: str
    stamp: float | None


@dataclass(frozen=True, eq=False, slots=True)
class Beams:
    """The ends of the valid beams of a scan, in the robot's frame. `sent` is the number of all beams;
    `is_mounted`: the place of the laser on the robot is known, not assumed to be its centre; `is_sought`: it
    may still be reported."""

    points: Points
    sent: int
    frame_id: str
    stamp: float | None
    is_mounted: bool
    is_sought: bool = False


@dataclass(frozen=True, eq=False, slots=True)
class PlannedPath:
    """The way that a robot plans to drive, in its map frame, from its start on."""

    points: Points
    frame_id: str
    stamp: float | None


@dataclass(frozen=True, eq=False, slots=True)
class CameraImage:
    """A picture as its camera compressed it, not yet decoded. `unshown`: the reason that there are no bytes
    to decode, empty if there are."""

    data: bytes
    stamp: float | None = None
    unshown: Message = EMPTY


@dataclass(frozen=True, eq=False, slots=True)
class Streamed:
    """The newest value of a stream. `at` is the monotonic second of its arrival, `taken_at` that of its
    stamp, or the arrival without one."""

    value: Beams | PlannedPath | CameraImage
    at: float
    taken_at: float


StreamValue = LaserScan | PlannedPath | CameraImage | Frames
"""A value of a stream as it comes from the wire."""


def beams_of(scan: LaserScan, mount: Pose | None, is_flipped: bool = False, is_sought: bool = False) -> Beams:
    """Return the ends of the beams that hit something within the laser's range; `mount` is the pose of the
    laser on the robot. A flipped laser hangs upside down and turns clockwise."""
    at = mount or Pose(0.0, 0.0)
    ranges = scan.ranges
    # A comparison with NaN is false: such a beam, null in JSON, is skipped like an infinite one.
    valid = (ranges >= scan.range_min) & (ranges <= scan.range_max) & (ranges < math.inf)
    angles = scan.angle_min + scan.angle_increment * np.flatnonzero(valid)
    angles = at.yaw + (-angles if is_flipped else angles)
    hit = ranges[valid]
    points = np.empty((len(hit), 2), dtype=np.float32)
    points[:, 0] = at.x + hit * np.cos(angles)
    points[:, 1] = at.y + hit * np.sin(angles)
    return Beams(points, len(ranges), scan.frame_id, scan.stamp, mount is not None, is_sought)


def placed(points: Points, pose: Pose) -> Points:
    """Return points of the robot's frame as points of the map, for a robot at a pose."""
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    turn = np.array([[cos, sin], [-sin, cos]])
    found: Points = (points @ turn + (pose.x, pose.y)).astype(np.float32)
    return found
