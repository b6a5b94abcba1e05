"""Where text goes so that it covers no other text: whole, or not at all."""

from functools import lru_cache

import numpy as np

from fleet_tui.view.cells import Inks
from fleet_tui.view.roles import Ink
from fleet_tui.view.text import cell_width

_REACH = 3  # rows or cells that a tag may be away from its robot
_THING, _TAG, _TEXT = 1, 2, 3
_HELD = np.zeros(len(Ink), np.uint8)
_HELD[Ink.VERTEX : Ink.TARGET + 1] = _TEXT  # vertices and labels


class Room:
    """Which cells of a view are taken already; `below` is what tags should not cover."""

    def __init__(self, width: int, height: int, below: Inks | None = None) -> None:
        self._width, self._height = width, height
        self._taken = bytearray(width * height) if below is None else bytearray(_HELD[below])

    def take(self, x: int, y: int, cells: int, by: int = _THING) -> None:
        """Take `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self._width)
        if 0 <= y < self._height and start < end:
            self._taken[y * self._width + start : y * self._width + end] = bytes((by,)) * (end - start)

    def free(self, x: int, y: int, cells: int) -> bool:
        """Whether they are all in the view and not taken."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self._width):
            return False
        start = y * self._width + x
        return self._taken.count(0, start, start + cells) == cells

    def label_spot(self, x: int, y: int, text: str, inks: Inks) -> tuple[int, int] | None:
        """The place for a label near its vertex at (x, y): taken, or None where there is no room.

        Of the free places the first one that hides least of the map; a label keeps a cell's distance
        from its neighbours, so that two labels never read as one.
        """
        cells = cell_width(text)
        middle = x - cells // 2
        right, left = x + 2, x - 1 - cells
        beside = ((right, y), (left, y), (middle, y - 1), (middle, y + 1))
        corners = ((right, y - 1), (right, y + 1), (left, y - 1), (left, y + 1))
        free = [spot for spot in beside if self._apart(*spot, cells)]
        free = free or [spot for spot in corners if self._apart(*spot, cells)]
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

        Where robots crowd, it dodges, the less the better: two numbers side by side read as one.
        Rather it covers a label; in a heap without any room there is none.
        """
        spot: tuple[int, int] | None = (x + glyph, y)
        if not self._clear(x + glyph, y, cells, x, y):
            alone, some = self._near_spots(x, y, glyph, cells)
            if alone is None and _TEXT in self._taken:
                alone, covering = self._bare()._near_spots(x, y, glyph, cells)
                some = some or covering
            spot = alone or some
        if spot:
            self.take(*spot, cells, _TAG)
        return spot

    def _bare(self) -> "Room":
        """The same without vertices and labels."""
        bare = Room(self._width, self._height)
        bare._taken = self._taken.replace(bytes((_TEXT,)), b"\0")
        return bare

    def _near_spots(
        self, x: int, y: int, glyph: int, cells: int
    ) -> tuple[tuple[int, int] | None, tuple[int, int] | None]:
        """The first place that touches nothing, else no tag; and the first that is free at all."""
        alone = some = None
        for dx, dy in _around(glyph, cells):
            spot = (x + dx, y + dy)
            if not self.free(*spot, cells):
                continue
            some = some or spot
            if self._clear(*spot, cells, x, y):
                return spot, some
            if alone is None and self._alone(*spot, cells):
                alone = spot
        return alone, some

    def _clear(self, start: int, row: int, cells: int, x: int, y: int) -> bool:
        """Whether a tag there is free and touches nothing but its own glyph at (x, y)."""
        before = 0 if row == y and x < start <= x + 2 else 1  # an arrow is one or two cells wide
        after = 0 if row == y and start + cells == x else 1
        return self.free(start - before, row, cells + before + after)

    def _alone(self, x: int, y: int, cells: int) -> bool:
        """Whether the places beside it are no tag's: two numbers side by side read as one."""
        row = y * self._width
        before = self._taken[row + x - 1] if x else 0
        after = self._taken[row + x + cells] if x + cells < self._width else 0
        return _TAG not in (before, after)


@lru_cache
def _around(glyph: int, cells: int) -> tuple[tuple[int, int], ...]:
    """Places for a tag relative to its glyph, from the one beside it outwards."""
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
    """How many of the cells hold something: a wall, an edge, a vertex."""
    return int(np.count_nonzero(inks > Ink.UNKNOWN))
