"""Placement of labels and numbers: whole and without overlap, or not at all."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.text.sanitize import cell_width
from fleet_tui.view.map.cells import Roles
from fleet_tui.view.roles import StyleRole

_MARGIN = 40  # cells between two rows of the bit mask, always taken to separate them
_HELD = np.zeros(len(StyleRole), np.bool_)
_HELD[StyleRole.VERTEX : StyleRole.TARGET + 1] = True  # vertices and labels


class CellOccupancy:
    """Occupancy of a view's cells; `below` are those that numbers should not cover.

    A bit for each cell in one number, row by row with margins between and around them: so neighbouring cells
    are tested together, which counts with a hundred robots ten times a second.
    """

    def __init__(self, width: int, height: int, below: Roles | None = None) -> None:
        self._width, self._height = width, height
        self._stride = width + _MARGIN
        self._taken = _margins(width, height)
        self._texts = 0 if below is None else _bits(_HELD[below], around=False)

    def _bit(self, x: int, y: int) -> int:
        """Return the number of a cell's bit."""
        return y * self._stride + _MARGIN + x

    def take(self, x: int, y: int, cells: int) -> None:
        """Occupy `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self._width)
        if 0 <= y < self._height and start < end:
            self._taken |= (1 << end - start) - 1 << self._bit(start, y)

    def free(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and neither taken nor to be spared."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self._width):
            return False
        return not (self._taken | self._texts) >> self._bit(x, y) & (1 << cells) - 1

    def number_side(self, x: int, y: int, arrow: int, cells: int, before: int) -> int:
        """Occupy the cells for a number of `cells` cells beside an arrow of `arrow` cells at (x, y).

        Return its side: -1 left, 1 right, 0 if it fits on neither. Beside it is only its
        arrow: two numbers never read as one. It stays on the side that it had `before`; else it covers a
        label only if both sides do.
        """
        sides = [side for side in (before or -1, -(before or -1)) if self._fits(x, y, arrow, cells, side)]
        if not sides:
            return 0
        spared = [side for side in sides if self.free(_start(x, arrow, cells, side), y, cells)]
        side = before if before in sides else [*spared, *sides][0]
        self.take(_start(x, arrow, cells, side), y, cells)
        return side

    def _fits(self, x: int, y: int, arrow: int, cells: int, side: int) -> bool:
        """Tell whether a number has free cells and no neighbour but its arrow."""
        start = _start(x, arrow, cells, side)
        if start < 0 or start + cells > self._width:
            return False
        beyond = start - 1 if side < 0 else start + cells
        held = self._taken >> self._bit(start, y) & (1 << cells) - 1
        return not held and (not 0 <= beyond < self._width or not self._taken >> self._bit(beyond, y) & 1)

    def label_spot(self, x: int, y: int, text: str, roles: Roles) -> tuple[int, int] | None:
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
        column, row = min(free, key=lambda spot: _hidden(roles[spot[1], spot[0] : spot[0] + cells]))
        self.take(column, row, cells)
        return column, row

    def _apart(self, x: int, y: int, cells: int) -> bool:
        start, end = max(x - 1, 0), min(x + cells + 1, self._width)
        return self.free(x, y, cells) and self.free(start, y, end - start)


def _start(x: int, arrow: int, cells: int, side: int) -> int:
    """Return the first cell of a number beside its arrow."""
    return x - cells if side < 0 else x + arrow


def _bits(cells: NDArray[np.bool_], around: bool) -> int:
    """The cells of a view, and their margins, as a CellOccupancy stores them."""
    height, width = cells.shape
    padded = np.full((height + 1, width + _MARGIN), around)
    padded[:height, _MARGIN:] = cells
    return int.from_bytes(np.packbits(padded, bitorder="little").tobytes(), "little")


@lru_cache(maxsize=8)
def _margins(width: int, height: int) -> int:
    return _bits(np.zeros((height, width), np.bool_), around=True)


def _hidden(roles: Roles) -> int:
    """Return the number of cells that hold something: a wall, an edge, a vertex."""
    return int(np.count_nonzero(roles > StyleRole.UNKNOWN))
