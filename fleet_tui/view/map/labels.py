"""Placement of labels: whole and without overlap, or not at all."""

from dataclasses import dataclass
from functools import lru_cache, reduce
from operator import or_

import numpy as np
from numpy.typing import NDArray

from fleet_tui.text.sanitize import cell_width
from fleet_tui.view.map.cells import Inks
from fleet_tui.view.roles import StyleRole

_REACH = 3  # maximum distance of a tag from its robot in rows or cells
_MARGIN = 40  # cells between two rows of the bit mask, always taken to separate them
LONGEST = _MARGIN - 2 * _REACH
"""Cells of the longest tag that can be placed."""

_HELD = np.zeros(len(StyleRole), np.bool_)
_HELD[StyleRole.VERTEX : StyleRole.TARGET + 1] = True  # vertices and labels


class Room:
    """Occupancy of a view's cells; `below` are those that tags should not cover.

    A bit for each cell in one number, row by row with margins between and around them: so all cells near a
    robot are tested together, which counts with a hundred robots ten times a second.
    """

    def __init__(self, width: int, height: int, below: Inks | None = None) -> None:
        self._width, self._height = width, height
        self._stride = width + _MARGIN
        self._taken = _margins(width, height)
        self._tags = 0
        self._texts = 0 if below is None else _bits(_HELD[below], around=False)

    def _bit(self, x: int, y: int) -> int:
        """Return the number of a cell's bit."""
        return (y + _REACH) * self._stride + _MARGIN + x

    def take(self, x: int, y: int, cells: int) -> None:
        """Occupy `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self._width)
        if 0 <= y < self._height and start < end:
            self._taken |= (1 << end - start) - 1 << self._bit(start, y)

    def free(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and not taken."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self._width):
            return False
        return not (self._taken | self._texts) >> self._bit(x, y) & (1 << cells) - 1

    def label_spot(self, x: int, y: int, text: str, inks: Inks) -> tuple[int, int] | None:
        """Occupy the place for a label near its vertex at (x, y), or return None if it doesn't fit.

        Of the free places the first one that hides least of the map; a label keeps a cell's distance from its
        neighbours, so that two labels never read as one.
        """
        cells = cell_width(text)
        middle = x - cells // 2
        right, left = x + 2, x - 1 - cells
        beside = ((right, y), (left, y), (middle, y - 1), (middle, y + 1))
        shifted = ((x, y - 1), (x, y + 1), (x + 1 - cells, y - 1), (x + 1 - cells, y + 1))
        corners = ((right, y - 1), (right, y + 1), (left, y - 1), (left, y + 1))
        for spots in (beside, shifted, corners):
            free = [spot for spot in spots if self._apart(*spot, cells)]
            if free:
                break
        else:
            return None
        column, row = min(free, key=lambda spot: _hidden(inks[spot[1], spot[0] : spot[0] + cells]))
        self.take(column, row, cells)
        return column, row

    def _apart(self, x: int, y: int, cells: int) -> bool:
        start, end = max(x - 1, 0), min(x + cells + 1, self._width)
        return self.free(x, y, cells) and self.free(start, y, end - start)

    def keep_tag(self, x: int, y: int, glyph: int, cells: int, dx: int, dy: int) -> bool:
        """Occupy the place of a tag at (dx, dy) from its glyph, if it is free and touches nothing else."""
        if cells > LONGEST:
            return False
        bit = self._bit(x + dx, y + dy)
        touched = (1 << cells + 2) - 1
        if dy == 0 and dx == glyph:
            touched -= 1  # the glyph itself
        elif dy == 0 and dx == -cells:
            touched >>= 1
        if (self._taken | self._texts) >> bit - 1 & touched:
            return False
        tag = (1 << cells) - 1 << bit
        self._taken |= tag
        self._tags |= tag
        return True

    def tag_spot(self, x: int, y: int, glyph: int, cells: int) -> tuple[int, int] | None:
        """Occupy the place for a robot's tag beside its glyph of `glyph` cells at (x, y).

        Among crowded robots it moves, as little as possible: two adjacent numbers read as one. It may cover a
        label; None if there is no space at all.
        """
        if cells > LONGEST:
            return None
        near = _near(glyph, cells, self._stride)
        corner = self._bit(x, y) - near.before
        taken, texts = self._taken >> corner & near.seen, self._texts >> corner & near.seen
        spot = near.spot(taken, texts, self._tags >> corner & near.seen)
        if spot is None:
            return None
        start, dx, dy = spot
        tag = start * ((1 << cells) - 1) << corner
        self._taken |= tag
        self._tags |= tag
        return x + dx, y + dy


def _bits(cells: NDArray[np.bool_], around: bool) -> int:
    """The cells of a view, and their margins, as stored in a Room."""
    height, width = cells.shape
    padded = np.full((height + 2 * _REACH + 1, width + _MARGIN), around)
    padded[_REACH : _REACH + height, _MARGIN:] = cells
    return int.from_bytes(np.packbits(padded, bitorder="little").tobytes(), "little")


@lru_cache(maxsize=8)
def _margins(width: int, height: int) -> int:
    return _bits(np.zeros((height, width), np.bool_), around=True)


@dataclass(frozen=True, slots=True, eq=False)
class _Near:
    """The surroundings of a glyph, as bits counted from a corner that lies `before` bits before it.

    seen: all cells relevant to a tag's place. order: possible starts, from beside the glyph outwards: the
    bit, and dx, dy from the glyph; starts: all these bits; after_glyph, before_glyph: those whose neighbour
    is the glyph itself.
    """

    cells: int
    before: int
    seen: int
    order: tuple[tuple[int, int, int], ...]
    starts: int
    after_glyph: int
    before_glyph: int

    def spot(self, taken: int, texts: int, tags: int) -> tuple[int, int, int] | None:
        """Return the first of the best places for a tag, if any."""
        alone, some = self.places(taken, texts, tags)
        if not alone and texts:
            alone, covering = self.places(taken, 0, tags)
            some = some or covering
        places = alone or some
        for spot in self.order:
            if places & spot[0]:
                return spot
        return None

    def places(self, taken: int, texts: int, tags: int) -> tuple[int, int]:
        """Return the starts of a tag at which it touches nothing; and those at which it is free at all.

        A tag rather touches a label than goes far from its robot.
        """
        held = blocked = taken | texts
        for cell in range(1, self.cells):
            blocked |= held >> cell
        free = self.starts & ~blocked
        touching = taken << 1 & ~self.after_glyph | taken >> self.cells & ~self.before_glyph
        clear = free & ~touching
        if clear and texts:
            texts &= ~taken
            beside = clear & (self.order[0][0] | self.order[1][0])
            clear = beside & ~(texts << 1 | texts >> self.cells) or clear
        return clear or free & ~(tags << 1 | tags >> self.cells), free


@lru_cache
def _near(glyph: int, cells: int, stride: int) -> _Near:
    before = _REACH * stride + cells + _REACH + 1
    order = tuple((1 << before + dy * stride + dx, dx, dy) for dx, dy in _around(glyph, cells))
    starts = sum(start for start, _, _ in order)
    return _Near(
        cells=cells,
        before=before,
        seen=reduce(or_, (starts << i >> 1 for i in range(cells + 2))),
        order=order,
        starts=starts,
        after_glyph=1 << before + 1 | 1 << before + 2,  # an arrow is one or two cells wide
        before_glyph=1 << before - cells,
    )


def _around(glyph: int, cells: int) -> tuple[tuple[int, int], ...]:
    """Return places for a tag relative to its glyph, from the one beside it outwards."""
    right, left = glyph, -cells
    places = [(right, 0), (left, 0)]
    for far in range(1, _REACH + 1):
        for row in (-far, far):
            places += [(at, row) for at in (right, 0, 1 - cells, left)]
        places += [(right + far, 0), (left - far, 0)]
        for row in range(1 - far, far):
            places += [(right + far, row), (left - far, row)]
    return tuple(dict.fromkeys(places))


def _hidden(inks: Inks) -> int:
    """Return the number of cells that hold something: a wall, an edge, a vertex."""
    return int(np.count_nonzero(inks > StyleRole.UNKNOWN))
