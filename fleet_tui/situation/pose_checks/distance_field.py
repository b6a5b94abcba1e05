"""Distances to the nearest occupied cell of a map, computed tile by tile where they are needed."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.grid import OCCUPIED, OccupancyGrid

FARTHEST = 2.0
"""Metres above which distances are not told apart."""
TILE = 128
"""Cells along each side of a tile."""
MOST_TILES = 4096
"""Tiles kept of a map: 64 MB."""
STEPS = 255
"""Steps of a distance, which is kept as a byte."""

Distances = NDArray[np.float32]


class DistanceField:
    """The distances of one map, in metres between centres of cells."""

    def __init__(self, grid: OccupancyGrid) -> None:
        self._grid = grid
        self._cap = max(1, min(TILE, int(FARTHEST / grid.frame.resolution)))
        self.farthest = self._cap * grid.frame.resolution
        """The distance of everything that is farther off, in metres."""
        self._tiles: dict[tuple[int, int], NDArray[np.uint8]] = {}

    def at(self, points: NDArray[np.floating]) -> Distances:
        """Return the distance at each of the points (n, 2), in metres of the world."""
        columns, rows = self._cells(points)
        height, width = self._grid.levels[0].shape
        # Also false for NaN, whose conversion to an integer would be anything.
        inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
        found = np.full(len(points), self.farthest, dtype=np.float32)
        column, row = columns[inside].astype(np.int64), rows[inside].astype(np.int64)
        down, right = row // TILE, column // TILE
        steps = np.empty(len(row), dtype=np.uint8)
        for key in set(zip(down.tolist(), right.tolist(), strict=True)):
            here = (down == key[0]) & (right == key[1])
            steps[here] = self._tile(key)[row[here] % TILE, column[here] % TILE]
        found[inside] = steps * np.float32(self.farthest / STEPS)
        return found

    def _cells(self, points: NDArray[np.floating]) -> tuple[Distances, Distances]:
        """Return column and row of each point, as `MapFrame.to_pixel` does for one."""
        frame = self._grid.frame
        sign = 1.0 if frame.added else -1.0
        dx = points[:, 0] + sign * frame.origin.x
        dy = points[:, 1] + sign * frame.origin.y
        cos, sin = np.cos(frame.origin.yaw), np.sin(frame.origin.yaw)
        right, up = cos * dx + sin * dy, cos * dy - sin * dx
        return np.floor(right / frame.resolution), np.floor(frame.height - up / frame.resolution)

    def _tile(self, key: tuple[int, int]) -> NDArray[np.uint8]:
        found = self._tiles.get(key)
        if found is None:
            if len(self._tiles) >= MOST_TILES:
                self._tiles.clear()
            found = self._tiles[key] = self._measured(*key)
        return found

    def _measured(self, down: int, right: int) -> NDArray[np.uint8]:
        """Return the distances of a tile, in steps: first along each row, then across the rows."""
        cap, cells = self._cap, self._grid.levels[0]
        top, left = down * TILE, right * TILE
        window = np.zeros((TILE + 2 * cap, TILE + 2 * cap), dtype=bool)
        y, x = max(0, top - cap), max(0, left - cap)
        part = cells[y : top + TILE + cap, x : left + TILE + cap] == OCCUPIED
        y, x = y - (top - cap), x - (left - cap)
        window[y : y + part.shape[0], x : x + part.shape[1]] = part
        if not part.any():
            return np.full((TILE, TILE), STEPS, dtype=np.uint8)
        along = _along_rows(window, cap)[:, cap : cap + TILE] ** 2
        squares = along[cap : cap + TILE].copy()
        for step in range(1, cap + 1):
            np.minimum(squares, along[cap + step : cap + step + TILE] + step * step, out=squares)
            np.minimum(squares, along[cap - step : cap - step + TILE] + step * step, out=squares)
        cellwise = np.minimum(np.sqrt(squares), cap)
        steps: NDArray[np.uint8] = np.round(cellwise * (STEPS / cap)).astype(np.uint8)
        return steps


def _along_rows(occupied: NDArray[np.bool_], cap: int) -> Distances:
    """Return the cells to the nearest occupied one in the same row; at least `cap` + 1 without one."""
    width = occupied.shape[1]
    index = np.arange(width)
    last = np.maximum.accumulate(np.where(occupied, index, -width), axis=1)
    coming = np.where(occupied, index, 2 * width)[:, ::-1]
    following = np.minimum.accumulate(coming, axis=1)[:, ::-1]
    nearest = np.minimum(index - last, following - index)
    return np.minimum(nearest, cap + 1).astype(np.float32)


@lru_cache(maxsize=2)
def distance_field(grid: OccupancyGrid) -> DistanceField:
    """Return the distances of a map, the same as long as the map is the same object."""
    return DistanceField(grid)
