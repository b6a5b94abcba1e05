"""Draws a floor's plan as the occupancy grid a mapping robot would have brought home.

Rectangles are (left, bottom, right, top) in metres of the world.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

RESOLUTION = 0.05  # metres per cell
# cells: 40 x 26 m
WIDTH = 800
HEIGHT = 520
ORIGIN = (-2.0, -3.0)  # the world's x, y of the lower left corner
UNKNOWN = -1
FREE = 0
OCCUPIED = 100

AISLE = 0.8  # metres kept free on both sides of an edge
SETBACK = 1.3  # metres between the middle of an aisle and the racks beside it
PASSAGE = 0.9  # metres at least between racks or pallets
THICK = 0.15  # metres of an inner wall

Cells = NDArray[np.int8]
Rect = tuple[float, float, float, float]
Spot = tuple[float, float]

_OUTSIDE: Rect = (-1.5, -2.5, 37.5, 22.5)
_INSIDE: Rect = (-1.3, -2.3, 37.3, 22.3)
_UNSEEN: tuple[Rect, ...] = ((36.1, 21.3, 37.3, 22.3), (-1.3, -2.3, -0.6, -1.5), (35.9, -2.3, 37.3, -1.6))


@dataclass(frozen=True)
class Plan:
    """The plan of a floor. Vertices are crossings of aisles, numbered row by row from the
    south west; `closed` lists neighbours without a way between them.

    `blocks` are the objects between the aisles, the northern row first: `r` racks, `p` pallets,
    `o` an office, `d` a closed room that is not mapped, `.` nothing.
    """

    columns: tuple[float, ...]
    rows: tuple[float, ...]
    blocks: tuple[str, ...]
    walls: tuple[Rect, ...]
    closed: frozenset[tuple[int, int]]
    labels: Mapping[int, str]
    elevator: tuple[int, str]
    docking: tuple[int, str]


def draw(plan: Plan, aisles: Iterable[tuple[Spot, Spot]], elevator: Spot) -> Cells:
    """The plan's cells, row 0 at the bottom. Aisles are cut last: where one meets a wall is a door."""
    cells = np.full((HEIGHT, WIDTH), UNKNOWN, dtype=np.int8)
    _paint(cells, _OUTSIDE, OCCUPIED)
    _paint(cells, _INSIDE, FREE)
    for corner in _UNSEEN:
        _paint(cells, corner, UNKNOWN)
    for wall in plan.walls:
        _paint(cells, wall, OCCUPIED)
    for row, (bottom, top) in zip(reversed(plan.blocks), pairwise(plan.rows), strict=True):
        for kind, (left, right) in zip(row, pairwise(plan.columns), strict=True):
            _block(cells, kind, (left + SETBACK, bottom + SETBACK, right - SETBACK, top - SETBACK))
    x, y = elevator
    _room(cells, (x - 1.2, y - 1.2, x + 1.2, y + 1.2), FREE)
    for start, end in aisles:
        _cut(cells, start, end)
    return cells


def _paint(cells: Cells, rect: Rect, value: int) -> None:
    left, bottom, right, top = rect
    x, y = ORIGIN
    columns = slice(round((left - x) / RESOLUTION), round((right - x) / RESOLUTION))
    rows = slice(round((bottom - y) / RESOLUTION), round((top - y) / RESOLUTION))
    cells[rows, columns] = value


def _block(cells: Cells, kind: str, rect: Rect) -> None:
    if kind == "r":
        _fill(cells, rect, (rect[2] - rect[0], 1.0))
    elif kind == "p":
        _fill(cells, rect, (1.2, 0.8))
    elif kind == "o":
        _room(cells, rect, FREE)
        middle = (rect[0] + rect[2]) / 2
        _paint(cells, (middle - 0.6, rect[1], middle + 0.6, rect[1] + THICK), FREE)
        _paint(cells, (rect[0] + 0.8, rect[3] - 1.4, rect[0] + 2.4, rect[3] - 0.7), OCCUPIED)
    elif kind == "d":
        _room(cells, rect, UNKNOWN)


def _fill(cells: Cells, rect: Rect, size: Spot) -> None:
    """Spread as many things of this size over the rectangle as fit with a passage between them."""
    left, bottom, right, top = rect
    for x in _spread(left, right, size[0]):
        for y in _spread(bottom, top, size[1]):
            _paint(cells, (x, y, x + size[0], y + size[1]), OCCUPIED)


def _spread(first: float, last: float, size: float) -> list[float]:
    count = max(1, math.floor((last - first + PASSAGE) / (size + PASSAGE)))
    step = (last - first - size) / max(1, count - 1)
    return [first + i * step for i in range(count)]


def _room(cells: Cells, rect: Rect, inside: int) -> None:
    left, bottom, right, top = rect
    _paint(cells, rect, OCCUPIED)
    _paint(cells, (left + THICK, bottom + THICK, right - THICK, top - THICK), inside)


def _cut(cells: Cells, start: Spot, end: Spot) -> None:
    """Free every cell that is nearer than AISLE to the line from start to end."""
    (x, y), (dx, dy) = start, (end[0] - start[0], end[1] - start[1])
    left, bottom = (
        math.floor((min(a, b) - AISLE - o) / RESOLUTION) for a, b, o in zip(start, end, ORIGIN, strict=True)
    )
    right, top = (
        math.ceil((max(a, b) + AISLE - o) / RESOLUTION) for a, b, o in zip(start, end, ORIGIN, strict=True)
    )
    xs = ORIGIN[0] + (np.arange(left, right) + 0.5) * RESOLUTION - x
    ys = (ORIGIN[1] + (np.arange(bottom, top) + 0.5) * RESOLUTION - y)[:, np.newaxis]
    along = np.clip((xs * dx + ys * dy) / (dx * dx + dy * dy), 0.0, 1.0)
    near = np.hypot(xs - along * dx, ys - along * dy) < AISLE
    cells[bottom:top, left:right][near] = FREE
