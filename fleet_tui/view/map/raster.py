"""The map's ground in terminal cells: quadrants, half-blocks or ASCII, sampled from the pyramid.

Every mode folds the same dots (2 x 4 per cell), each the maximum of exactly the pixels it
covers, so that a wall one pixel thick is in the picture at any zoom. Walls are solid blocks; dots of braille
are left to routes and trails.
"""

import math
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, Classes
from fleet_tui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.roles import StyleRole

COARSE = 12.0
"""Pixels per dot from which nearly every dot contains some wall: then only edges stay solid, and the inside
of walls is as dense as in the map."""


def ground(grid: OccupancyGrid | None, camera: Camera, drawing: Drawing, hatched: bool = False) -> Cells:
    """Return the map as the camera sees it; without a grid the extent is empty floor. `hatched`: mark unknown
    ground with sparse dots, for terminals on which its colour doesn't show."""
    cells = _ground(grid, camera, drawing)
    if hatched and drawing is not Drawing.ASCII:
        left, top = camera.origin
        rows, columns = np.ogrid[top : top + camera.height, left : left + camera.width]
        marked = (cells.roles == StyleRole.UNKNOWN) & (rows % 2 == 0) & ((columns + rows) % 4 == 0)
        cells.codes[marked] = _HATCH
    return cells


def _ground(grid: OccupancyGrid | None, camera: Camera, drawing: Drawing) -> Cells:
    left, top = camera.origin
    shape = (camera.height * DOTS_Y, camera.width * DOTS_X)
    if grid is None:
        dots = _empty(camera, left * DOTS_X, top * DOTS_Y, shape)
    elif camera.scale > COARSE and drawing is not Drawing.ASCII:
        return _coarse(grid, camera, drawing)
    else:
        dots = sample(grid, camera.scale, left * DOTS_X, top * DOTS_Y, shape)
    return _ascii(dots) if drawing is Drawing.ASCII else _blocks(dots, drawing)


def _coarse(grid: OccupancyGrid, camera: Camera, drawing: Drawing) -> Cells:
    """Return the ground with solid edges and walls in two tones inside. Computed with one more cell on each
    side, so that the view's own rim is no edge."""
    left, top = camera.origin
    shape = ((camera.height + 2) * DOTS_Y, (camera.width + 2) * DOTS_X)
    part = (camera.scale, (left - 1) * DOTS_X, (top - 1) * DOTS_Y, shape)
    dots, shares = sample(grid, *part), _shares(grid, *part)
    cells = _blocks(dots, drawing, shares)
    return Cells(cells.codes[1:-1, 1:-1], cells.roles[1:-1, 1:-1])


def sample(grid: OccupancyGrid, scale: float, left: int, top: int, shape: tuple[int, int]) -> Classes:
    """Classes of the dots from (left, top) on, shape (rows, columns); unknown outside the map.

    scale: map pixels per dot; dot k covers pixels k * scale to (k + 1) * scale.
    """
    depth = min(max(math.floor(math.log2(scale)), 0), len(grid.levels) - 1)
    level = grid.levels[depth]
    step = scale / 2**depth
    rows, columns = shape
    top_in, first_y, last_y = _partition(top, rows, step, level.shape[0])
    left_in, first_x, last_x = _partition(left, columns, step, level.shape[1])
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


def _shares(grid: OccupancyGrid, scale: float, left: int, top: int, shape: tuple[int, int]) -> Classes:
    """Return the share of wall in each dot, sampled at 2 x 2 points: 0 to 4. Only known inside the map."""
    depth = max(math.floor(math.log2(scale)) - 3, 0)
    level = grid.levels[min(depth, len(grid.levels) - 1)]
    rows, columns = (
        np.clip((start + (np.arange(2 * count) + 0.5) / 2) * scale / 2**depth, 0, size - 1).astype(np.intp)
        for start, count, size in ((top, shape[0], level.shape[0]), (left, shape[1], level.shape[1]))
    )
    walls = (level.take(rows, 0).take(columns, 1) == OCCUPIED).view(np.uint8)
    tall: Classes = walls[0::2] + walls[1::2]
    return tall[:, 0::2] + tall[:, 1::2]


def _empty(camera: Camera, left: int, top: int, shape: tuple[int, int]) -> Classes:
    """Return floor over the whole extent of a missing map."""
    rows = (np.arange(top, top + shape[0]) + 0.5) * camera.scale
    columns = (np.arange(left, left + shape[1]) + 0.5) * camera.scale
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


# Unicode numbers a braille cell's dots 0 3 / 1 4 / 2 5 / 6 7; seen as bits.
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
BRAILLE = np.arange(0x2800, 0x2900, dtype=np.uint32)
BRAILLE[0] = ord(" ")  # some fonts draw rings for the empty pattern
_HATCH, _SOLID = ord("·"), ord("█")
_WALLS = np.array([StyleRole.UNKNOWN, StyleRole.FLOOR, StyleRole.WALL_BEYOND, StyleRole.WALL], np.uint8)


def pack(mask: NDArray[np.bool_]) -> Classes:
    """A mask of dots to the bits of its braille cells (uint8, a quarter as high, half as wide)."""
    dots = mask.view(np.uint8)
    bits = dots[0::DOTS_Y, 0::DOTS_X] * np.uint8(_BITS[0][0])
    for y in range(DOTS_Y):
        for x in range(DOTS_X):
            if x or y:
                bits |= dots[y::DOTS_Y, x::DOTS_X] * np.uint8(_BITS[y][x])
    return bits


def thicken(mask: NDArray[np.bool_], straight: NDArray[np.bool_]) -> Classes:
    """Return lines of two dots' width, as the bits of braille cells. The `straight` ones among them, along an
    axis, take one row of cells, not two."""
    thick, slanted = mask.copy(), mask & ~straight
    thick[:-1] |= slanted[1:]
    thick[:, :-1] |= slanted[:, 1:]
    for row in range(DOTS_Y):
        thick[row - 1 if row else 1 :: DOTS_Y] |= straight[row::DOTS_Y]
    thick[:, ::DOTS_X] |= straight[:, 1::DOTS_X]
    thick[:, 1::DOTS_X] |= straight[:, ::DOTS_X]
    return pack(thick)


def _known(dots: Classes) -> NDArray[np.bool_]:
    """Return the cells on known ground: of their dots without a wall at least half are free."""
    free, unknown = (_counts(dots == one) for one in (FREE, UNKNOWN))
    return free >= unknown


def _counts(dots: NDArray[np.bool_]) -> Classes:
    """Return the number of set dots per cell."""
    return _summed(dots.view(np.uint8))


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


def _blocks(dots: Classes, drawing: Drawing, shares: Classes | None = None) -> Cells:
    """Return blocks of 2 x 2 quadrants per cell, or of halves. With `shares` the inside of walls is in two
    tones."""
    columns = DOTS_X if drawing is Drawing.BRAILLE else 1
    walls = _folded(dots, DOTS_Y // 2, DOTS_X // columns) == OCCUPIED
    bits = np.zeros((walls.shape[0] // 2, walls.shape[1] // columns), np.uint8)
    for bit in range(2 * columns):
        bits |= walls[bit // columns :: 2, bit % columns :: columns].view(np.uint8) << np.uint8(bit)
    codes = (_QUADRANTS if drawing is Drawing.BRAILLE else _HALVES)[bits]
    if shares is not None:
        toned = ~_folded(~_inside(walls), 2, columns)
        full = DOTS_X * DOTS_Y * 4
        codes[toned] = _TONES[(_summed(shares)[toned] * 2 >= full).astype(np.intp)]
    roles = _WALLS[(bits > 0) * np.uint8(2) + _known(dots)]
    roles[codes == _SOLID] = StyleRole.WALL_SOLID
    return Cells(codes, roles)


_ASCII = np.zeros(3, np.uint32)
_ASCII[[UNKNOWN, FREE, OCCUPIED]] = [ord(" "), ord("."), ord("#")]
_ASCII_ROLES = np.zeros(3, np.uint8)
_ASCII_ROLES[[UNKNOWN, FREE, OCCUPIED]] = [StyleRole.UNKNOWN, StyleRole.FLOOR, StyleRole.WALL]


def _ascii(dots: Classes) -> Cells:
    classes = _folded(dots, DOTS_Y, DOTS_X)
    return Cells(_ASCII[classes], _ASCII_ROLES[classes])
