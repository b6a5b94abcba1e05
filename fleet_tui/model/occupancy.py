"""Builds the occupancy grid: classes, with their pyramid.

UNKNOWN < FREE < OCCUPIED, so that one max-pool means "occupied wins, then known": a wall one
cell thick stays in every level.
"""

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.grid import FREE as FREE
from fleet_tui.model.grid import OCCUPIED as OCCUPIED
from fleet_tui.model.grid import UNKNOWN as UNKNOWN
from fleet_tui.model.grid import OccupancyGrid, check_frame
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message

Classes = NDArray[np.uint8]


def _halved(level: Classes) -> Classes:
    rows, columns = level.shape
    if rows % 2 or columns % 2:
        level = np.pad(level, ((0, rows % 2), (0, columns % 2)))
    tall = np.maximum(level[0::2], level[1::2])
    return np.maximum(tall[:, 0::2], tall[:, 1::2])


def build_grid(frame: MapFrame, classes: Classes) -> OccupancyGrid:
    """Build the pyramid over `classes` (uint8, shape (height, width), row 0 at the top)."""
    levels = [np.ascontiguousarray(classes)]
    while max(levels[-1].shape) > 1:
        levels.append(_halved(levels[-1]))
    return OccupancyGrid(frame, tuple(levels))


def _ros_table(occupied_from: int, free_to: int) -> Classes:
    """Class of every int8 occupancy, indexed by its byte: -1 unknown, 0..100 per cent."""
    table = np.full(256, UNKNOWN, dtype=np.uint8)
    table[0 : free_to + 1] = FREE
    table[occupied_from : 100 + 1] = OCCUPIED
    return table


CLASS_OF_CELL = _ros_table(occupied_from=65, free_to=25)
"""map_server's defaults: above 65 % occupied, below 25 % free (0.196 of older ones rounds here too)."""


def grid_from_ros(frame: MapFrame, data: bytes) -> OccupancyGrid:
    """An OccupancyGrid's int8 data (row-major from the LOWER left cell, -1 or 0..100) to classes.

    Raises MapError where size and data disagree.
    """
    check_frame(frame)
    if len(data) != frame.width * frame.height:
        raise MapError(
            Message(
                "map of {width} x {height} px has {cells} cells instead of {expected}",
                width=frame.width,
                height=frame.height,
                cells=f"{len(data):,}",
                expected=f"{frame.width * frame.height:,}",
            )
        )
    cells = np.frombuffer(data, dtype=np.uint8).reshape(frame.height, frame.width)
    return build_grid(frame, CLASS_OF_CELL[cells[::-1]])
