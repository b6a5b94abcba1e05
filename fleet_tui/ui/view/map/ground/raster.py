"""The map's ground in terminal cells: quadrants, half-blocks or ASCII, sampled from the pyramid.

Every mode folds the same dots (2 x 4 per cell), each the maximum of exactly the pixels it
covers, so that a wall one pixel thick is in the picture at any zoom. Walls are solid blocks; dots of braille
are left to routes and trails.
"""

import math
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, Classes
from fleet_tui.ui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.ground.walls import RIM, wall_blocks
from fleet_tui.ui.view.map.places import Points
from fleet_tui.ui.view.map.tracing import Mask, trace
from fleet_tui.ui.view.roles import StyleRole

COARSE = 12.0
"""Pixels per dot from which nearly every dot contains some wall: then only edges stay solid, and the inside
of walls is as dense as in the map."""
_BLOCK = {Drawing.BRAILLE: (2, 1), Drawing.HALF_BLOCK: (2, 2), Drawing.ASCII: (4, 2)}
"""Rows and columns of dots in a block of wall."""

Lines = tuple[Points, Points]
Scales = tuple[float, float]
"""Map pixels per dot across and down."""


def ground(
    grid: OccupancyGrid | None,
    camera: Camera,
    drawing: Drawing,
    hatched: bool = False,
    ways: Lines | None = None,
) -> Cells:
    """Return the map as the camera sees it; without a grid the extent is empty floor. `hatched`: mark unknown
    ground with sparse dots, for terminals on which its colour doesn't show; `ways`: both ends, in map pixels,
    of the lines along which robots drive: they stay open where the map does."""
    cells = _ground(grid, camera, drawing, ways)
    if hatched and drawing is not Drawing.ASCII:
        left, top = camera.origin
        rows, columns = np.ogrid[top : top + camera.height, left : left + camera.width]
        marked = (cells.roles == StyleRole.UNKNOWN) & (rows % 2 == 0) & ((columns + rows) % 4 == 0)
        cells.codes[marked] = _HATCH
    return cells


def _ground(grid: OccupancyGrid | None, camera: Camera, drawing: Drawing, ways: Lines | None) -> Cells:
    taller, wider = _BLOCK[drawing]
    finer = 2 // wider
    if grid is None:
        floor = _empty(camera)
        no_wall = np.zeros((floor.shape[0] // taller, floor.shape[1] // wider), np.bool_)
        return _drawn(floor.repeat(finer, 1), no_wall, drawing)
    # What is beyond the view decides on its rim, which is no edge of a wall.
    around = replace(camera, width=camera.width + 2 * RIM, height=camera.height + 2 * RIM)
    left, top = around.origin
    part = (camera.dot, left * DOTS_X, top * DOTS_Y, (around.height * DOTS_Y, around.width * DOTS_X))
    dots = sample(grid, *part, finer)
    walls = _folded(dots == OCCUPIED, taller // 2, 1)
    blocks = wall_blocks(walls, None if ways is None else _passed(ways, around, walls.shape))
    is_coarse = camera.scale > COARSE and drawing is not Drawing.ASCII
    shares = _shares(grid, *part) if is_coarse else None
    cells = _drawn(dots, blocks, drawing, shares)
    return Cells(cells.codes[RIM:-RIM, RIM:-RIM], cells.roles[RIM:-RIM, RIM:-RIM])


def _passed(ways: Lines, camera: Camera, shape: tuple[int, ...]) -> Mask:
    """Return the parts of the view that lines pass, given by their ends in map pixels."""
    passed = np.zeros(shape, np.bool_)
    per_pixel = np.array(shape[::-1]) / np.multiply((camera.width, camera.height), camera.cell)
    corner = np.multiply(camera.origin, camera.cell)
    starts, stops = ((ends - corner) * per_pixel for ends in ways)
    trace(passed, starts, stops)
    return passed


def sample(
    grid: OccupancyGrid, scales: Scales, left: int, top: int, shape: tuple[int, int], finer: int = 1
) -> Classes:
    """Classes of the dots from (left, top) on, shape (rows, columns); unknown outside the map.

    scales: map pixels per dot across and down; dot k covers pixels k * scale to (k + 1) * scale. finer:
    columns of each dot.
    """
    depth = min(max(math.floor(math.log2(min(scales))) - 1, 0), len(grid.levels) - 1)
    level = grid.levels[depth]
    across, down = (scale / 2**depth for scale in scales)
    left, shape = left * finer, (shape[0], shape[1] * finer)
    rows, columns = shape
    top_in, first_y, last_y = _partition(top, rows, down, level.shape[0])
    left_in, first_x, last_x = _partition(left, columns, across / finer, level.shape[1])
    if not (first_y.size and first_x.size):
        return np.zeros(shape, np.uint8)
    seen = level[first_y[0] : last_y[-1] + 1, first_x[0] : last_x[-1] + 1]
    seen = _pooled(_pooled(seen, first_y, last_y, 0), first_x, last_x, 1)
    if seen.shape == shape:
        return seen
    dots = np.zeros(shape, np.uint8)
    dots[top_in : top_in + seen.shape[0], left_in : left_in + seen.shape[1]] = seen
    return dots


_Indices = NDArray[np.intp]


def _partition(start: int, count: int, step: float, size: int) -> tuple[int, _Indices, _Indices]:
    """Return the first and last entry of each dot that overlaps 0..size.

    Also the number of dots before the first of them. Dot k ends where dot k + 1 begins.
    """
    bounds = np.floor(np.arange(start, start + count + 1) * step).astype(np.intp)
    first, last = bounds[:-1], np.maximum(bounds[1:] - 1, bounds[:-1])
    inside = (last >= 0) & (first < size)
    before = int(inside.argmax()) if inside.any() else 0
    return before, np.maximum(first[inside], 0), np.minimum(last[inside], size - 1)


def _pooled(level: Classes, first: _Indices, last: _Indices, axis: int) -> Classes:
    """Maximum over first..last (inclusive) for each dot along one axis."""
    first, last = first - first[0], last - first[0]
    found: Classes = level.take(first, axis)
    between = int((last - first).max())
    for further in range(1, between + 1):
        np.maximum(found, level.take(np.minimum(first + further, last), axis), out=found)
    return found


def _shares(grid: OccupancyGrid, scales: Scales, left: int, top: int, shape: tuple[int, int]) -> Classes:
    """Return the share of wall in each dot, sampled at 2 x 2 points: 0 to 4. Only known inside the map."""
    depth = max(math.floor(math.log2(min(scales))) - 3, 0)
    level = grid.levels[min(depth, len(grid.levels) - 1)]
    rows, columns = (
        np.clip((start + (np.arange(2 * count) + 0.5) / 2) * scale / 2**depth, 0, size - 1).astype(np.intp)
        for start, count, size, scale in (
            (top, shape[0], level.shape[0], scales[1]),
            (left, shape[1], level.shape[1], scales[0]),
        )
    )
    walls = (level.take(rows, 0).take(columns, 1) == OCCUPIED).view(np.uint8)
    tall: Classes = walls[0::2] + walls[1::2]
    return tall[:, 0::2] + tall[:, 1::2]


def _empty(camera: Camera) -> Classes:
    """Return floor over the whole extent of a missing map."""
    (left, top), (across, down) = camera.origin, camera.dot
    rows = (np.arange(camera.height * DOTS_Y) + top * DOTS_Y + 0.5) * down
    columns = (np.arange(camera.width * DOTS_X) + left * DOTS_X + 0.5) * across
    in_rows = (rows >= 0) & (rows < camera.extent[1])
    in_columns = (columns >= 0) & (columns < camera.extent[0])
    return (in_rows[:, None] & in_columns).astype(np.uint8) * np.uint8(FREE)


_Dots = TypeVar("_Dots", np.uint8, np.bool_)


def _folded(dots: NDArray[_Dots], rows: int, columns: int) -> NDArray[_Dots]:
    """Return the maximum over blocks of rows x columns dots."""
    found = dots[::rows]
    for row in range(1, rows):
        found = np.maximum(found, dots[row::rows])
    wide = found
    found = wide[:, ::columns]
    for column in range(1, columns):
        found = np.maximum(found, wide[:, column::columns])
    return found


def _summed(shares: Classes) -> Classes:
    """Return the sums over cells."""
    tall = shares[0::4] + shares[1::4] + shares[2::4] + shares[3::4]
    return tall[:, 0::2] + tall[:, 1::2]


_HATCH = ord("·")
_SOLID = ord("█")
_WALLS = np.array([StyleRole.UNKNOWN, StyleRole.FLOOR, StyleRole.WALL_BEYOND, StyleRole.WALL], np.uint8)


def _known(dots: Classes, walls: Mask, columns: int) -> Mask:
    """Return the cells, of 2 rows and so many `columns` of blocks, on known ground: beside their drawn walls
    at least half is free."""
    free = (dots == FREE).view(np.int8) - (dots == UNKNOWN).view(np.int8)
    tall = free[0::2] + free[1::2]
    seen = (tall[:, 0::2] + tall[:, 1::2]) * ~walls
    known = seen[0::2] + seen[1::2]
    return np.asarray(sum(known[:, column::columns] for column in range(columns)) >= 0)


def _inside(walls: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the walls with walls on all four sides."""
    inside = np.zeros_like(walls)
    inside[1:-1, 1:-1] = walls[:-2, 1:-1] & walls[2:, 1:-1] & walls[1:-1, :-2] & walls[1:-1, 2:]
    return inside & walls


def _letters(text: str) -> NDArray[np.uint32]:
    return np.array([ord(letter) for letter in text], np.uint32)


_HALVES = _letters(" ▀▄█")
_QUADRANTS = _letters(" ▘▝▀▖▌▞▛▗▚▐▜▄▙▟█")
_TONES = _letters("▒▓")


def _drawn(dots: Classes, walls: Mask, drawing: Drawing, shares: Classes | None = None) -> Cells:
    """Return blocks of 2 x 2 quadrants per cell, of halves, or letters. With `shares` the inside of walls is
    in two tones."""
    if drawing is Drawing.ASCII:
        return _ascii(dots, walls)
    columns = DOTS_X if drawing is Drawing.BRAILLE else 1
    bits = np.zeros((walls.shape[0] // 2, walls.shape[1] // columns), np.uint8)
    for bit in range(2 * columns):
        bits |= walls[bit // columns :: 2, bit % columns :: columns].view(np.uint8) << np.uint8(bit)
    codes = (_QUADRANTS if drawing is Drawing.BRAILLE else _HALVES)[bits]
    if shares is not None:
        toned = ~_folded(~_inside(walls), 2, columns)
        full = DOTS_X * DOTS_Y * 4
        codes[toned] = _TONES[(_summed(shares)[toned] * 2 >= full).astype(np.intp)]
    roles = _WALLS[(bits > 0) * np.uint8(2) + _known(dots, walls, columns)]
    roles[codes == _SOLID] = StyleRole.WALL_SOLID
    return Cells(codes, roles)


_ASCII = np.zeros(3, np.uint32)
_ASCII[[UNKNOWN, FREE, OCCUPIED]] = [ord(" "), ord("."), ord("#")]
_ASCII_ROLES = np.zeros(3, np.uint8)
_ASCII_ROLES[[UNKNOWN, FREE, OCCUPIED]] = [StyleRole.UNKNOWN, StyleRole.FLOOR, StyleRole.WALL]


def _ascii(dots: Classes, walls: Mask) -> Cells:
    classes = _folded(np.where(dots == OCCUPIED, UNKNOWN, dots).astype(np.uint8), DOTS_Y, DOTS_X)
    classes[walls] = OCCUPIED
    return Cells(_ASCII[classes], _ASCII_ROLES[classes])
