"""The free floor ahead of a robot's footprint, by the map alone: what moves about there is on no map."""

import math

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Pose
from fleet_tui.model.grid import FREE, UNKNOWN, OccupancyGrid
from fleet_tui.model.set_up.driving import Speeds

FAR = 2.0
"""Metres that are looked ahead."""
FINE = 0.04
"""Metres of a cell that are fine enough: a finer map is looked at more coarsely."""
USUAL_SIZE = (0.4, 0.4)
"""Metres of a robot whose size is not configured."""


def clearance(grid: OccupancyGrid, pose: Pose, size: tuple[float, float], speeds: Speeds) -> float | None:
    """Return the metres from the footprint, `size` long and wide, to the next cell along its motion that is
    not free, FAR at most; None if it only turns or its place is on no map."""
    metres = speeds.linear
    if metres == 0.0 or not all(map(math.isfinite, (pose.x, pose.y, pose.yaw))):
        return None
    level = _level(grid)
    side = grid.frame.resolution * 2**level
    half = (size[0] / 2 + side / 2, size[1] / 2 + side / 2)
    blocked = _blocked(grid, level, pose, FAR + math.hypot(*half))
    way = np.array([speeds.ahead / metres, speeds.sideways / metres])
    before_it = blocked[blocked @ way > 0.0]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # When the cell, moving against the robot, enters and leaves each pair of the footprint's sides.
        ends = np.stack([(before_it - half) / way, (before_it + half) / way])
    inside = np.abs(before_it) <= half
    ends = np.where(way == 0.0, np.where(inside, [[[-np.inf]], [[np.inf]]], np.nan), ends)
    enters, leaves = np.min(ends, axis=0).max(axis=1), np.max(ends, axis=0).min(axis=1)
    hits = enters[enters <= leaves]
    return float(np.clip(hits.min(), 0.0, FAR)) if hits.size else FAR


def _level(grid: OccupancyGrid) -> int:
    levels = range(len(grid.levels))
    return max((one for one in levels if grid.frame.resolution * 2**one <= FINE), default=0)


def _blocked(grid: OccupancyGrid, level: int, pose: Pose, reach: float) -> NDArray[np.float64]:
    """Return the cells within reach that are not free, as metres ahead and to the left of the robot. Beyond
    the map all is unknown."""
    cells, frame = grid.levels[level], grid.frame
    middle = np.array(frame.to_pixel(pose.x, pose.y)) / 2**level
    pixels = math.ceil(reach / frame.resolution / 2**level) + 1
    column, row = (int(at) for at in np.clip(middle, -(2**30), 2**30))
    columns = np.arange(column - pixels, column + pixels + 1)
    rows = np.arange(row - pixels, row + pixels + 1)
    near = np.full((rows.size, columns.size), UNKNOWN, np.uint8)
    on_rows = (rows >= 0) & (rows < cells.shape[0])
    on_columns = (columns >= 0) & (columns < cells.shape[1])
    near[np.ix_(on_rows, on_columns)] = cells[np.ix_(rows[on_rows], columns[on_columns])]
    down, across = np.nonzero(near != FREE)
    offsets = np.stack([columns[across] + 0.5, rows[down] + 0.5], axis=1) - middle
    axes = [_axis(grid, pose, yaw) for yaw in (pose.yaw, pose.yaw + math.pi / 2)]
    found: NDArray[np.float64] = offsets @ np.array(axes).T * frame.resolution**2 * 2**level
    return found


def _axis(grid: OccupancyGrid, pose: Pose, yaw: float) -> tuple[float, float]:
    """Return a metre in a direction, in pixels."""
    column, row = grid.frame.to_pixel(pose.x, pose.y)
    along, down = grid.frame.to_pixel(pose.x + math.cos(yaw), pose.y + math.sin(yaw))
    return along - column, down - row
