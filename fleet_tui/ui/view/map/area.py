"""The part of a floor that a fitted view shows: of many maps most is unknown ground."""

import math
from collections.abc import Iterable
from functools import lru_cache

import numpy as np

from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.ui.view.map.camera import Area
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex

MARGIN = 0.5
"""Metres around the known ground."""
STEP = 5.0
"""Metres by which a robot outside it extends the area: a fitted view should rarely change."""
NEAR = 10.0
"""Metres beyond the map up to which a robot is shown with it: one farther away is lost."""
_FINE = 1024  # cells of a level that are searched at most, per side


def worth_seeing(scene: Scene, robots: Iterable[SceneRobot]) -> Area | None:
    """Return the known cells, the vertices and the robots on or near the map; None without a map."""
    if scene.grid is None:
        return None
    area, frame = _still(scene.grid, scene.vertices, scene.frame), scene.frame
    step, near = STEP / frame.resolution, NEAR / frame.resolution
    for robot in robots:
        column, row = frame.to_pixel(robot.pose.x, robot.pose.y)
        left, top, right, bottom = area
        if not (left <= column <= right and top <= row <= bottom) and _is_on(frame, column, row, near):
            left, top = min(left, column // step * step), min(top, row // step * step)
            right, bottom = max(right, (column // step + 1) * step), max(bottom, (row // step + 1) * step)
            area = left, top, right, bottom
    return area


def _is_on(frame: MapFrame, column: float, row: float, near: float = 0.0) -> bool:
    """Tell whether a pixel is on the map, or as near to it."""
    return -near <= column < frame.width + near and -near <= row < frame.height + near


@lru_cache(maxsize=1)  # of the shown floor: an old live map must not be kept alive
def _still(grid: OccupancyGrid, vertices: tuple[SceneVertex, ...], frame: MapFrame) -> Area:
    """Return the area of what doesn't move, around the whole map if nothing of it is known."""
    boxes = [_known(grid)]
    for vertex in vertices:
        column, row = frame.to_pixel(vertex.x, vertex.y)
        if math.isfinite(column) and math.isfinite(row) and _is_on(frame, column, row):
            boxes.append((column, row, column, row))
    found = [box for box in boxes if box is not None]
    if not found:
        return 0.0, 0.0, float(frame.width), float(frame.height)
    lefts, tops, rights, bottoms = zip(*found, strict=True)
    margin = MARGIN / frame.resolution
    return min(lefts) - margin, min(tops) - margin, max(rights) + margin, max(bottoms) + margin


def _known(grid: OccupancyGrid) -> Area | None:
    """Return the box around the known cells."""
    depth = next((k for k, level in enumerate(grid.levels) if max(level.shape) <= _FINE), 0)
    level, cell = grid.levels[depth], 2**depth
    rows, columns = np.flatnonzero(level.any(axis=1)), np.flatnonzero(level.any(axis=0))
    if not rows.size:
        return None
    right, bottom = (
        min((columns[-1] + 1) * cell, grid.frame.width),
        min((rows[-1] + 1) * cell, grid.frame.height),
    )
    return float(columns[0] * cell), float(rows[0] * cell), float(right), float(bottom)
