"""The cells of a view that are taken, and the places left for numbers and labels."""

import sys
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.text.sanitize import cell_width
from fleet_tui.view.map.cells import Roles
from fleet_tui.view.map.places import Place
from fleet_tui.view.roles import WALLS, StyleRole

_MARGIN = 40  # cells between two rows of the bit mask, always taken to separate them
_OFF_FLOOR = np.zeros(len(StyleRole), np.bool_)
_OFF_FLOOR[[StyleRole.UNKNOWN, *WALLS]] = True
_HELD = np.zeros(len(StyleRole), np.bool_)
_HELD[StyleRole.VERTEX : StyleRole.TARGET + 1] = True  # vertices and labels


_WALL, _FAR, _ASTRAY = 255, 3, 60
"""Costs of a label: for each wall's cell that it covers, two rows off its vertex, and there on the floor."""
_WALLS = (*WALLS, StyleRole.MISSION_THROUGH, StyleRole.MISSION_NEXT_THROUGH)
# Along edges robots drive, over a label. As bytes: of so few cells it is several times as fast.
_WEIGHTS = bytes(
    _WALL if role in _WALLS else 4 if role == StyleRole.EDGE else role > StyleRole.UNKNOWN
    for role in range(256)
)


class CellOccupancy:
    """Occupancy of a view's cells; `below` are those that numbers should not cover.

    A bit for each cell in one number, row by row with margins between and around them: so neighbouring cells
    are tested together, which counts with a hundred robots ten times a second.
    """

    def __init__(self, width: int, height: int, below: Roles | None = None) -> None:
        self.width, self._height = width, height
        self._stride = width + _MARGIN
        self._taken = _margins(width, height)
        self._numbers = 0
        self._texts = 0 if below is None else _bits(_HELD[below], around=False)
        self._beyond = 0 if below is None else _bits(_OFF_FLOOR[below], around=False)

    def _bit(self, x: int, y: int) -> int:
        """Return the number of a cell's bit."""
        return y * self._stride + _MARGIN + x

    def take(self, x: int, y: int, cells: int) -> None:
        """Occupy `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self.width)
        if 0 <= y < self._height and start < end:
            self._taken |= (1 << end - start) - 1 << self._bit(start, y)

    def free(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and neither taken nor to be spared."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self.width):
            return False
        return not (self._taken | self._texts) >> self._bit(x, y) & (1 << cells) - 1

    def has_room(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and none is taken, whatever is to be spared."""
        return 0 <= y < self._height and x >= 0 and x + cells <= self.width and not self.is_taken(x, y, cells)

    def is_taken(self, x: int, y: int, cells: int) -> bool:
        """Tell whether one of these cells, all in the view, is occupied."""
        return bool(self._taken >> self._bit(x, y) & (1 << cells) - 1)

    def number_side(self, x: int, y: int, arrow: int, cells: int, before: int, spares: bool = False) -> int:
        """Occupy the cells for a number of `cells` cells beside an arrow of `arrow` cells at (x, y).

        Return its side: -1 left, 1 right, 0 if it fits on neither. Beside it is only its arrow: two numbers
        never read as one. On the floor it stays on the side that it had `before`, if need be beside the arrow
        of a robot that drives past; else it covers a label only if both sides do, none at all if it `spares`
        them."""
        if before and not spares and self._fits(x, y, arrow, cells, before, self._numbers):
            start = _start(x, arrow, cells, before)
            if not self._is_beyond(start, y, cells) and not self._touches(start, y, cells, before):
                self._take_number(start, y, cells)
                return before
        sides = [side for side in (-1, 1) if self._fits(x, y, arrow, cells, side, self._taken)]
        if not sides:
            return 0
        # Touching a label it reads as a part of that.
        sides.sort(key=lambda side: self._touches(_start(x, arrow, cells, side), y, cells, side))
        spared = [side for side in sides if self.free(_start(x, arrow, cells, side), y, cells)]
        if spares and not spared:
            return 0
        # A number beyond the floor's edge reads as one of nothing, and one on a wall breaks it: rather than
        # that a label moves.
        on_floor = [side for side in sides if not self._is_beyond(_start(x, arrow, cells, side), y, cells)]
        best = [side for side in on_floor if side in spared] or (on_floor if not spares else spared)
        best = best or spared or sides
        stays = before in best and not self._touches(_start(x, arrow, cells, before), y, cells, before)
        side = before if stays else best[0]
        self._take_number(_start(x, arrow, cells, side), y, cells)
        return side

    def number_over(self, x: int, y: int, cells: int) -> int | None:
        """Occupy the cells for a number of `cells` cells in place of an arrow at (x, y), with nothing beside
        it, rather over no label. Return the first one, None without space."""
        own = 1 << self._bit(x, y)
        for kept_clear in (self._texts, 0):
            for start in dict.fromkeys((x - cells + 1, x)):
                left, right = max(start - 1, 0), min(start + cells + 1, self.width)
                if start < 0 or start + cells > self.width:
                    continue
                around = ((1 << right - left) - 1 << self._bit(left, y)) & ~own
                if not self._taken & around and not kept_clear >> self._bit(start, y) & (1 << cells) - 1:
                    self._take_number(start, y, cells)
                    return start
        return None

    def extends(self, x: int, y: int, cells: int, side: int) -> bool:
        """Occupy cells of a row that continue to a `side`, if they and the next one are free and in view."""
        if not 0 <= y < self._height or not self._fits(
            x if side > 0 else x + cells, y, 0, cells, side, self._taken
        ):
            return False
        self._take_number(x, y, cells)
        return True

    def _take_number(self, x: int, y: int, cells: int) -> None:
        self.take(x, y, cells)
        self._numbers |= (1 << cells) - 1 << self._bit(x, y)

    def _touches(self, x: int, y: int, cells: int, side: int) -> bool:
        """Tell whether the next cell on a side is one to be spared."""
        beyond = x - 1 if side < 0 else x + cells
        return 0 <= beyond < self.width and bool(self._texts >> self._bit(beyond, y) & 1)

    def _is_beyond(self, x: int, y: int, cells: int) -> bool:
        return bool(self._beyond >> self._bit(x, y) & (1 << cells) - 1)

    def _fits(self, x: int, y: int, arrow: int, cells: int, side: int, kept_clear: int) -> bool:
        """Tell whether a number has free cells, and the next one is none of those `kept_clear`."""
        start = _start(x, arrow, cells, side)
        if start < 0 or start + cells > self.width:
            return False
        beyond = start - 1 if side < 0 else start + cells
        held = self._taken >> self._bit(start, y) & (1 << cells) - 1
        return not held and (not 0 <= beyond < self.width or not kept_clear >> self._bit(beyond, y) & 1)

    def label_spot(
        self, x: int, y: int, text: str, roles: Roles, covers_walls: bool = False, in_row: bool = True
    ) -> tuple[int, int] | None:
        """Occupy the place for a label near its vertex at (x, y), in its row if `in_row`. Return None if it
        doesn't fit, or only over a wall unless it `covers_walls`.

        Of the free places it is the one that hides least of the map, rather beside the vertex; a label keeps
        two cells' distance from its neighbours, so that two labels never read as one."""
        cells = cell_width(text)
        best: Place | None = None
        least = sys.maxsize if covers_walls else _WALL
        for right, down, further in _spots(cells, in_row):
            if least <= further:
                break
            column, row = x + right, y + down
            if not self._apart(column, row, cells):
                continue
            cost = further + sum(roles[row, column : column + cells].tobytes().translate(_WEIGHTS))
            if further == _FAR and roles[row, x] != StyleRole.UNKNOWN:
                # On the floor it is read as of its vertex only without a wall below it or between.
                if cost >= _WALL or roles[(y + row) // 2, x] in _WALLS:
                    continue
                cost += _ASTRAY
            best, least = ((column, row), cost) if cost < least else (best, least)
        if best is not None:
            self.take(best[0] - 1, best[1], cells + 2)
        return best

    def _apart(self, x: int, y: int, cells: int) -> bool:
        if not (0 <= y < self._height and x >= 0 and x + cells <= self.width):
            return False
        start, end = max(x - 1, 0), min(x + cells + 1, self.width)
        # As `free`, without its call: this is asked a dozen times for each label.
        held = (self._taken | self._texts) >> y * self._stride + _MARGIN + start
        return not held & (1 << end - start) - 1


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


@lru_cache(maxsize=128)
def _spots(cells: int, in_row: bool) -> tuple[tuple[int, int, int], ...]:
    """Return the places for a label of so many cells, the best first: cells right of its vertex, rows below
    it, and a cost."""
    middle, end, right, left = -(cells // 2), 1 - cells, 2, -1 - cells
    beside = [(right, 0), (left, 0)] if in_row else []
    beside += [(middle, -1), (middle, 1)]
    shifted = [(0, -1), (0, 1), (end, -1), (end, 1)]
    corners = [(right, -1), (right, 1), (left, -1), (left, 1)]
    far = [(column, row) for column in (0, end, middle, -1, end + 1) for row in (-2, 2)]
    return tuple((*at, cost) for cost, places in enumerate((beside, shifted, corners, far)) for at in places)
