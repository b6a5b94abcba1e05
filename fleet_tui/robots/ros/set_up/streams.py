"""Messages of streams: sensor_msgs/LaserScan and nav_msgs/Path. With numpy: imported on use."""

import math
from typing import Any

import cbor2
import msgspec
import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.set_up.streams import LaserScan, PlannedPath
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import FARTHEST
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import LONGEST_NAME, truncate

MOST_BEAMS = 20_000
MOST_POSES = 20_000
"""Beams of a scan, and poses of a path, above which a message is rejected."""
FINEST = 0.05
"""Metres between two points of a path: a planner has one for each cell."""
FLOATS = {81: ">f4", 82: ">f8", 85: "<f4", 86: "<f8"}
"""Typed arrays of floats in CBOR (RFC 8746), by tag."""


class _ScanMessage(msgspec.Struct, frozen=True):
    """sensor_msgs/LaserScan. JSON has null for NaN and the infinities, also for `range_max`."""

    angle_min: float
    angle_increment: float
    ranges: Any
    range_min: float | None = None
    range_max: float | None = None
    header: ros.Header = ros.Header("")


class _PathMessage(msgspec.Struct, frozen=True):
    """nav_msgs/Path: of each pose only the position is read."""

    poses: list["_PathPlace"]
    header: ros.Header = ros.Header("")


class _PathPosition(msgspec.Struct, frozen=True):
    position: ros.Point


class _PathPlace(msgspec.Struct, frozen=True):
    pose: _PathPosition


_read_scan = ros.reader(_ScanMessage)
_read_path = ros.reader(_PathMessage)


def read_scan(msg: object) -> LaserScan:
    """Read a laser scan. Raises WireError."""
    message = _read_scan(msg)
    first, step = message.angle_min, message.angle_increment
    if not (math.isfinite(first) and math.isfinite(step)) or max(abs(first), abs(step)) > 100.0:
        raise WireError(f"angle_min {first}, angle_increment {step}: no angles")
    low = message.range_min if message.range_min is not None else 0.0
    high = message.range_max if message.range_max is not None else math.inf
    frame = truncate(message.header.frame_id.lstrip("/"), LONGEST_NAME)
    ranges = _numbers(message.ranges)
    # NaN as a limit excludes nothing: a range of 0 or less is none, whatever the limits are.
    low, high = max(low, 1e-6) if low == low else 1e-6, min(high, FARTHEST) if high == high else FARTHEST
    return LaserScan(ranges, first, step, low, high, frame, message.header.stamp.seconds)


def _numbers(value: object) -> NDArray[np.float32]:
    """Return a list with nulls, or a typed array of CBOR, as numbers. Raises WireError."""
    if isinstance(value, cbor2.CBORTag) and value.tag in FLOATS and isinstance(value.value, bytes):
        dtype = np.dtype(FLOATS[value.tag])
        if len(value.value) % dtype.itemsize:
            raise WireError(f"ranges: {len(value.value)} bytes are no whole number of floats")
        found = np.frombuffer(value.value, dtype=dtype)
    elif isinstance(value, list):
        _check_count(len(value), MOST_BEAMS, "ranges")
        try:
            found = np.array(msgspec.convert(value, list[float | None]), dtype=np.float64)
        except msgspec.ValidationError as problem:
            raise WireError(f"ranges: {problem}") from None
    else:
        raise WireError("ranges: neither a list nor an array of floats")
    _check_count(len(found), MOST_BEAMS, "ranges")
    with np.errstate(over="ignore"):  # a number beyond float32 is infinite: no beam
        return found.astype(np.float32)


def _check_count(count: int, most: int, what: str) -> None:
    if count > most:
        raise WireError(f"{what}: {count:,} elements, the limit is {most:,}")


def read_path(msg: object) -> PlannedPath:
    """Read a planned path, thinned out to one point per cell; its end is always kept. Raises WireError."""
    message = _read_path(msg)
    _check_count(len(message.poses), MOST_POSES, "poses")
    found = np.array(
        [(place.pose.position.x, place.pose.position.y) for place in message.poses], dtype=np.float64
    ).reshape(-1, 2)
    if not (np.abs(found) <= FARTHEST).all():
        raise WireError("poses: a position is not a finite number")
    frame = truncate(message.header.frame_id.lstrip("/"), LONGEST_NAME)
    return PlannedPath(_thinned(found).astype(np.float32), frame, message.header.stamp.seconds)


def _thinned(points: NDArray[np.float64]) -> NDArray[np.float64]:
    if len(points) < 3:
        return points
    cells = np.round(points / FINEST)
    keep = np.ones(len(points), dtype=bool)
    keep[1:] = (cells[1:] != cells[:-1]).any(axis=1)
    keep[-1] = True
    return points[keep]
