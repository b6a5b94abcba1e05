"""The cells of a view that are taken, and the places left for numbers and labels."""

import sys
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.map.cells import Roles
from fleet_tui.ui.view.map.places import Place
from fleet_tui.ui.view.map.placing.chips import ChipSize, shifts_of
from fleet_tui.ui.view.roles import LABELS, WALLS, StyleRole

_HELD = np.zeros(len(StyleRole), np.bool_)
_HELD[StyleRole.VERTEX : StyleRole.TARGET + 1] = True  # vertices and labels


_WALL = 255
_AMONG = 70
_FAR = 60
_ASTRAY = 60
_NOWHERE = 10_000
"""Costs of a label: for each wall's cell if it is to cover none, beside a wall in another row than its
vertex, where it reads as the name of what the wall encloses, two rows off its vertex, and there on the
floor, or behind a wall."""
_THROUGH = StyleRole.LABEL_THROUGH, StyleRole.TARGET_THROUGH
_WALLED = frozenset((*WALLS, StyleRole.MISSION_THROUGH, StyleRole.MISSION_NEXT_THROUGH))


def _weights(wall: int, unknown: int = 0) -> bytes:
    """Return the costs of a label by the role of what it covers: along edges robots drive, over it. As bytes:
    of so few cells it is several times as fast."""
    costs = {StyleRole.EDGE: 4, StyleRole.FLOOR: 0, StyleRole.UNKNOWN: unknown}
    return bytes(wall if role in _WALLED else costs.get(role, 1) for role in StyleRole) + bytes(
        256 - len(StyleRole)
    )


_BESIDE_WALLS = _weights(_WALL)
_OVER_WALLS = _weights(10)
_OVER_OUTER_WALLS = _weights(3, unknown=6)
_STAYS = 3
_TOUCHES = 2
"""Costs of a chip: by how much another place must be better, and at a label."""
_END = 16
"""The cost of a cell that is to be kept clear."""
_BEYOND = (StyleRole.UNKNOWN, StyleRole.WALL_BEYOND, StyleRole.LABEL_BEYOND, StyleRole.TARGET_BEYOND)
_OUTSIDE = 6
"""The cost of a cell outside the building: a chip there says that its robot is outside, too."""
# A chip may hide ground and lines; it rather keeps off walls, and names give way to it.
_HIDDEN = np.array(
    [
        _OUTSIDE if role in _BEYOND else 2 if role in _WALLED or role in _THROUGH else int(role in LABELS)
        for role in range(len(StyleRole))
    ],
    np.uint8,
)


class CellOccupancy:
    """Occupancy of a view's cells; `below` are those that numbers should not cover.

    A bit for each cell in one number for each row: so neighbouring cells are tested together, which counts
    with a hundred robots ten times a second.
    """

    def __init__(self, width: int, height: int, below: Roles | None = None) -> None:
        self.width = width
        self._height = height
        self._taken = [0] * height
        self._texts = [0] * height if below is None else _bits(_HELD[below])
        self._hidden = bytearray() if below is None else bytearray(_hidden(below).tobytes())

    def take(self, x: int, y: int, cells: int) -> None:
        """Occupy `cells` cells of row y from x on, as far as they are in the view."""
        start, end = max(x, 0), min(x + cells, self.width)
        if 0 <= y < self._height and start < end:
            self._taken[y] |= (1 << end - start) - 1 << start

    def release(self, x: int, y: int, cells: int) -> None:
        """Free cells of the view that were taken."""
        self._taken[y] &= ~((1 << cells) - 1 << x)

    def keep_clear(self, x: int, y: int) -> None:
        """Keep chips off a cell of the view, if there is other space near their robots."""
        self._hidden[y * self.width + x] = _END

    def free(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and neither taken nor to be spared."""
        if not (0 <= y < self._height and x >= 0 and x + cells <= self.width):
            return False
        return not (self._taken[y] | self._texts[y]) >> x & (1 << cells) - 1

    def has_room(self, x: int, y: int, cells: int) -> bool:
        """Tell whether they are all in the view and none is taken, whatever is to be spared."""
        return 0 <= y < self._height and x >= 0 and x + cells <= self.width and not self.is_taken(x, y, cells)

    def is_taken(self, x: int, y: int, cells: int) -> bool:
        """Tell whether one of these cells, all in the view, is occupied."""
        return self.taken(x, y, cells) > 0

    def taken(self, x: int, y: int, cells: int) -> int:
        """Return which of these cells, all in the view, are occupied, as bits."""
        return self._taken[y] >> x & (1 << cells) - 1

    def chip_shift(
        self, x: int, y: int, chip: ChipSize, before: Place | None, far: bool = False
    ) -> Place | None:
        """Occupy the place for a chip of the robot at (x, y), and return its first cell as seen from the
        robot's: cells right, rows down. None without space. One with a text stays in its robot's row and
        covers no label; `far`: two rows off its robot.

        Of the free places near the robot it is the one that hides least; it stays at the shift `before`
        unless another is much better. A chip keeps a cell's distance from those in its row."""
        shifts = shifts_of(chip, far)
        best: Place | None = None
        least = sys.maxsize
        if before in shifts and (cost := self._chip_cost(x, y, before, chip)) is not None:
            best, least = before, cost + shifts[before] - _STAYS
        for shift, further in shifts.items():
            if least <= further:
                break
            cost = self._chip_cost(x, y, shift, chip)
            if cost is not None and cost + further < least:
                best, least = shift, cost + further
        if best is not None:
            self.take(x + best[0], y + best[1], chip.cells)
        return best

    def widen(self, x: int, y: int, cells: int, more: int) -> int | None:
        """Occupy more cells right or left of a chip, on the side on which it hides less, and return its
        first cell then; None if that leaves no cell to the chips beside it."""
        best, least = None, sys.maxsize
        for first, added in ((x, x + cells), (x - more, x - more)):
            start, end = max(added - (first < x), 0), min(added + more + (first == x), self.width)
            if first < 0 or first + cells + more > self.width or self.is_taken(start, y, end - start):
                continue
            place = y * self.width + added
            if (cost := sum(self._hidden[place : place + more])) < least:
                best, least = first, cost
        if best is not None:
            self.take(best, y, cells + more)
        return best

    def _chip_cost(self, x: int, y: int, shift: Place, chip: ChipSize) -> int | None:
        """Return what a chip hides, None if it has no space."""
        start, row, cells = x + shift[0], y + shift[1], chip.cells
        if not (0 <= row < self._height and start >= 0 and start + cells <= self.width):
            return None
        left = start - 1 if start else 0
        around = (1 << start + cells + 1 - left) - 1  # right of the view nothing is taken
        if self._taken[row] >> left & around:
            return None
        texts = self._texts[row] >> left & around
        if texts and chip.has_text:
            return None
        first = row * self.width + start
        hidden = sum(self._hidden[first : first + cells])
        own = (1 << cells) - 1 << start - left
        return hidden + _TOUCHES if texts & ~own else hidden

    def label_spot(
        self, x: int, y: int, text: str, roles: Roles, covers_walls: bool = False, in_row: bool = True
    ) -> tuple[int, int] | None:
        """Occupy the place for a label near its vertex at (x, y), in its row if `in_row`. Return None if it
        doesn't fit, or only over a wall inside the building unless it `covers_walls`.

        Of the free places it is the one that hides least of the map, rather beside the vertex; a label keeps
        two cells' distance from its neighbours, so that two labels never read as one."""
        cells = cell_width(text)
        best: Place | None = None
        least, over_walls = (sys.maxsize, _OVER_WALLS) if covers_walls else (_WALL, _BESIDE_WALLS)
        for right, down, further in _spots(cells, in_row):
            if least <= further:
                break
            at = x + right, y + down
            if self._apart(*at, cells):
                cost = further + _label_cost((x, y), at, cells, roles, over_walls)
                best, least = (at, cost) if cost < least else (best, least)
        if best is not None:
            self.take(best[0] - 1, best[1], cells + 2)
        return best

    def _apart(self, x: int, y: int, cells: int) -> bool:
        if not (0 <= y < self._height and x >= 0 and x + cells <= self.width):
            return False
        start, end = max(x - 1, 0), min(x + cells + 1, self.width)
        # As `free`, without its call: this is asked a dozen times for each label.
        held = (self._taken[y] | self._texts[y]) >> start
        return not held & (1 << end - start) - 1


def _label_cost(vertex: Place, at: Place, cells: int, roles: Roles, over_walls: bytes) -> int:
    """Return what a label of a vertex hides there, and how much it would read as another one's."""
    (x, y), (column, row) = vertex, at
    down, is_floor = row - y, roles[row, x] != StyleRole.UNKNOWN
    if abs(down) == 1 and 0 <= row + down < len(roles) and roles[row + down, x] == StyleRole.UNKNOWN:
        return sum(roles[row, column : column + cells].tobytes().translate(_OVER_OUTER_WALLS))
    cost = sum(roles[row, column : column + cells].tobytes().translate(over_walls))
    if down and not _WALLED.isdisjoint(roles[row, max(column - 1, 0) : column + cells + 1].tobytes()):
        cost += _AMONG
    if abs(down) == 2 and is_floor:
        # There it is read as of its vertex only without a wall below it or between.
        cost += _ASTRAY if cost < _AMONG and roles[(y + row) // 2, x] not in _WALLED else _NOWHERE
    return cost


def _hidden(below: Roles) -> NDArray[np.uint8]:
    """Return what a chip would hide in each cell."""
    costs = _HIDDEN[below]
    outside, outer = costs == _OUTSIDE, costs == _HIDDEN[StyleRole.WALL]
    beside = np.ones_like(outside)  # at the view's edge may be the building's
    beside[1:-1, 1:-1] = False
    beside[1:] |= outside[:-1]
    beside[:-1] |= outside[1:]
    beside[:, 1:] |= outside[:, :-1]
    beside[:, :-1] |= outside[:, 1:]
    costs[outer & beside] = _OUTSIDE - 1
    return costs


def _bits(cells: NDArray[np.bool_]) -> list[int]:
    """The cells of a view as a CellOccupancy stores them."""
    packed = np.packbits(cells, axis=1, bitorder="little")
    return [int.from_bytes(row.tobytes(), "little") for row in packed]


@lru_cache(maxsize=128)
def _spots(cells: int, in_row: bool) -> tuple[tuple[int, int, int], ...]:
    """Return the places for a label of so many cells, the best first: cells right of its vertex, rows below
    it, and a cost."""
    middle, end, right, left = -(cells // 2), 1 - cells, 2, -1 - cells
    beside = [(right, 0), (left, 0)] if in_row else []
    beside += [(middle, -1), (middle, 1)]
    shifted = [(column, row) for column in (0, end, -1, end + 1) for row in (-1, 1)]
    corners = [(right, -1), (right, 1), (left, -1), (left, 1)]
    far = [(column, row) for column in (0, end, middle, -1, end + 1) for row in (-2, 2)]
    ranked = ((0, beside), (1, shifted), (2, corners), (_FAR, far))
    return tuple((*at, cost) for cost, places in ranked for at in places)
