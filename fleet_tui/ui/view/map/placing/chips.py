"""The size of a robot's chip, and its places as seen from the robot."""

from functools import lru_cache
from typing import NamedTuple

from fleet_tui.ui.view.map.places import Place


class ChipSize(NamedTuple):
    """The size of a chip: its cells, and of them those of its arrow and number, which stand at the robot; a
    text is right of these or, if it `is_left`, left of them."""

    cells: int
    head: int
    is_left: bool = False

    @property
    def has_text(self) -> bool:
        """Tell whether a text is beside the number."""
        return self.cells > self.head


@lru_cache(maxsize=512)
def shifts_of(chip: ChipSize, far: bool) -> dict[Place, int]:
    """Return the places for a chip, as seen from its robot, with their costs, the best first: its arrow or
    number over the robot's cell, beside it, in the next rows; with a text only over it. `far`: two rows
    off."""
    cells = chip.cells
    first = cells - chip.head if chip.is_left else 0
    over = {(-first - right, 0): right for right in range(chip.head)}
    if chip.has_text:
        return over
    ends = (0, 0), (1 - cells, 0), (1, 1), (-cells, 1)
    if far:
        return {(right, down): away for right, away in ends for down in (-2, 2)}
    beside = {(right, 0): 4 + right for right in (1, 2)} | {
        (1 - cells - left, 0): 4 + left for left in (1, 2)
    }
    rows = {(right, down): 8 + away for down in (-1, 1) for right, away in ends}
    return dict(sorted((over | beside | rows).items(), key=lambda one: one[1]))
