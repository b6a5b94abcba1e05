"""Where text goes so that it covers no other text: whole, or not at all."""

import numpy as np

from fleet_tui.view.cells import Inks
from fleet_tui.view.roles import Ink
from fleet_tui.view.text import cell_width


class Room:
    """Which cells of a view are taken already."""

    def __init__(self, width: int, height: int) -> None:
        self._width, self._height = width, height
        self._taken = bytearray(width * height)

    def take(self, x: int, y: int, cells: int) -> None:
        """Take `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self._width)
        if 0 <= y < self._height and start < end:
            self._taken[y * self._width + start : y * self._width + end] = b"\1" * (end - start)

    def free(self, x: int, y: int, cells: int) -> bool:
        """Whether they are all in the view and not taken."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self._width):
            return False
        start = y * self._width + x
        return self._taken.find(1, start, start + cells) < 0

    def label_spot(self, x: int, y: int, text: str, inks: Inks) -> tuple[int, int] | None:
        """The place for a label near its vertex at (x, y): taken, or None where there is no room.

        Of the free places the first one that hides least of the map; a label keeps a cell's distance
        from its neighbours, so that two labels never read as one.
        """
        cells = cell_width(text)
        middle = x - cells // 2
        spots = ((x + 2, y), (x - 1 - cells, y), (middle, y - 1), (middle, y + 1))
        free = [spot for spot in spots if self._apart(*spot, cells)]
        if not free:
            return None
        column, row = min(free, key=lambda spot: _hidden(inks[spot[1], spot[0] : spot[0] + cells]))
        self.take(column, row, cells)
        return column, row

    def _apart(self, x: int, y: int, cells: int) -> bool:
        start, end = max(x - 1, 0), min(x + cells + 1, self._width)
        return self.free(x, y, cells) and self.free(start, y, end - start)

    def tag_spot(self, x: int, y: int, glyph: int, cells: int) -> tuple[int, int] | None:
        """The place for a robot's tag beside its glyph of `glyph` cells at (x, y); now taken.

        Where robots crowd, it dodges; in a heap without any room there is none.
        """
        right, left = x + glyph, x - cells
        spots = [(right, y)]
        if not self._clear(right, y, cells, x, y):
            around = [(at, side) for side in (-1, 1, -2, 2) for at in (right, x, x - cells + 1, left)]
            spots = [(right, y), (left, y), *((at, y + side) for at, side in around)]
            clear = [spot for spot in spots if self._clear(*spot, cells, x, y)]
            spots = clear or [spot for spot in spots if self.free(*spot, cells)]
        if not spots:
            return None
        self.take(*spots[0], cells)
        return spots[0]

    def _clear(self, start: int, row: int, cells: int, x: int, y: int) -> bool:
        """Whether a tag there is free and touches nothing but its own glyph at (x, y)."""
        before = 0 if row == y and start > x else 1
        after = 0 if row == y and start < x else 1
        return self.free(start - before, row, cells + before + after)


def _hidden(inks: Inks) -> int:
    """How many of the cells hold something: a wall, an edge, a vertex."""
    return int(np.count_nonzero(inks > Ink.UNKNOWN))
