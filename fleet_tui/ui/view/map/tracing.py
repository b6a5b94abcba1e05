"""Lines as the dots that they pass, and dots as the letters of braille."""

from functools import lru_cache
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.by_identity import Same
from fleet_tui.model.geometry import Line
from fleet_tui.ui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.ui.view.map.places import Points, pixels
from fleet_tui.ui.view.map.scene import Scene

Mask = NDArray[np.bool_]
"""The dots of a view, (rows, columns)."""
# Unicode numbers a braille cell's dots 0 3 / 1 4 / 2 5 / 6 7; seen as bits.
_BITS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
BRAILLE = np.arange(0x2800, 0x2900, dtype=np.uint32)
BRAILLE[0] = ord(" ")  # some fonts draw rings for the empty pattern


def blank_mask(camera: Camera) -> Mask:
    """Return no dots."""
    return np.zeros((camera.height * DOTS_Y, camera.width * DOTS_X), np.bool_)


def dots_of(scene: Scene, camera: Camera, points: Points) -> Points:
    """Return points in metres (n x 2) as fractions of the view's dots."""
    left, top = camera.origin
    return pixels(scene.frame, points) / camera.dot - (left * DOTS_X, top * DOTS_Y)


@lru_cache(maxsize=8)
def _as_array(lines: Same[tuple[Line, ...]]) -> Points:
    # Twice as fast as from a list of tuples.
    numbers = np.fromiter(chain.from_iterable(lines.value), np.float64, 4 * len(lines.value))
    return numbers.reshape(-1, 4)


def pixels_of(scene: Scene, lines: tuple[Line, ...]) -> tuple[Points, Points]:
    """Return the ends of lines in metres as map pixels."""
    ends = _as_array(Same(lines))
    return pixels(scene.frame, ends[:, :2]), pixels(scene.frame, ends[:, 2:])


def ends_of(scene: Scene, camera: Camera, lines: tuple[Line, ...]) -> tuple[Points, Points]:
    """Return the ends of lines in metres as fractions of the view's dots."""
    ends = _as_array(Same(lines))
    return dots_of(scene, camera, ends[:, :2]), dots_of(scene, camera, ends[:, 2:])


@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def trace(mask: Mask, starts: Points, stops: Points, dashed: bool = False, done: float = 0.0) -> None:
    """Set the dots (x, y) along each line, after cutting the lines to the mask and by the share `done`."""
    low, high = within(mask.shape, starts, stops)
    way = stops - starts
    # Column by column: numpy reduces many short rows several times as slowly.
    seen = (low < high) & np.isfinite(way[:, 0]) & np.isfinite(way[:, 1])
    starts, way, low, high = starts[seen], way[seen], low[seen], high[seen]
    steps = (np.maximum(*np.abs(way.T)) * (high - low)).astype(np.intp) + 2
    along = np.arange(steps.sum()) - np.repeat(np.cumsum(steps) - steps, steps)
    # Each line repeated: several times as fast as picking its row for each dot.
    share = np.repeat(low, steps) + np.repeat(high - low, steps) * along / np.repeat(steps - 1, steps)
    x, y = (
        np.repeat(start, steps) + np.repeat(length, steps) * share
        for start, length in zip(starts.T, way.T, strict=True)
    )
    if done or dashed:
        kept = share >= done
        if dashed:
            kept &= along % 4 < 2
        x, y = x[kept], y[kept]
    _set(mask, x, y)


def set_dots(mask: Mask, dots: Points) -> None:
    """Set the dots at x, y, as far as they are in the mask."""
    _set(mask, dots[:, 0], dots[:, 1])


def _set(mask: Mask, x: NDArray[np.float64], y: NDArray[np.float64]) -> None:
    rows, columns = mask.shape
    inside = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
    mask[y[inside].astype(np.intp), x[inside].astype(np.intp)] = True


def within(shape: tuple[int, ...], starts: Points, stops: Points) -> tuple[Points, Points]:
    """Return the shares of each line's length between which it is inside the mask (Liang-Barsky)."""
    size = np.array([shape[1], shape[0]], np.float64)
    one, other = -starts / (stops - starts), (size - starts) / (stops - starts)
    # A line along an axis divides by zero: +-inf outside, nan exactly on the border (taken as inside).
    low = np.nan_to_num(np.minimum(one, other), nan=-np.inf, neginf=-np.inf, posinf=np.inf)
    high = np.nan_to_num(np.maximum(one, other), nan=np.inf, neginf=-np.inf, posinf=np.inf)
    return np.maximum(low.max(axis=1), 0.0), np.minimum(high.min(axis=1), 1.0)


def pack(mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """A mask of dots to the bits of its braille cells (uint8, a quarter as high, half as wide)."""
    dots = mask.view(np.uint8)
    bits = dots[0::DOTS_Y, 0::DOTS_X] * np.uint8(_BITS[0][0])
    for y in range(DOTS_Y):
        for x in range(DOTS_X):
            if x or y:
                bits |= dots[y::DOTS_Y, x::DOTS_X] * np.uint8(_BITS[y][x])
    return bits


def thicken(mask: NDArray[np.bool_], straight: NDArray[np.bool_]) -> NDArray[np.uint8]:
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
