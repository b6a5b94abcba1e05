"""Walls at the scale of the picture: thin ones stay, and narrow ways between them stay open."""

from functools import reduce
from operator import and_, or_
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fleet_tui.ui.view.map.tracing import Mask

REACH = 2
"""Blocks from which a thin wall goes on along the rim of another."""
Bits = NDArray[np.uint8]
"""Blocks as bits, eight of a row in each byte: a frame has tens of thousands."""
Quarters = tuple[Bits, Bits, Bits, Bits]
"""The parts of blocks: upper left, upper right, lower left, lower right."""
RIM = REACH + 2
"""Blocks beside a block that decide on it."""


def wall_blocks(parts: Mask, ways: Mask | None = None) -> Mask:
    """Return the blocks that are drawn as wall. `parts`: the walls, in 2 x 2 parts for each block; `ways`:
    the parts in which robots drive.

    A block is wall where it contains some, unless that is less than its half and the rim of a wall that is
    drawn beside it: walls are as thick as they are, not thicker by up to a block on each side. So is a block
    free if robots drive in it past its wall. But no wall vanishes: each is drawn in its block or in one that
    touches it.
    """
    own = _quarters(parts)
    walls = reduce(or_, own)
    if ways is not None:
        passed = _quarters(ways)
        stays = ~reduce(or_, passed) | reduce(or_, map(and_, own, passed))
        top_left, top_right, low_left, low_right = own
        own = top_left & stays, top_right & stays, low_left & stays, low_right & stays
    drawn = reduce(or_, own) & ~_rims(own)
    shown = drawn | (walls & ~_around(drawn))
    return np.unpackbits(shown, axis=1, count=parts.shape[1] // 2).view(np.bool_)


def _quarters(parts: Mask) -> Quarters:
    """Return of each block the parts at its upper left, upper right, lower left and lower right."""
    # Copied: work on columns or rows that lie apart takes several times as long.
    left, right = (np.packbits(parts[:, side::2].copy(), axis=1) for side in (0, 1))
    return left[0::2].copy(), right[0::2].copy(), left[1::2].copy(), right[1::2].copy()


def _rims(own: Quarters) -> Bits:
    """Return the blocks with nothing but the rim of the wall in a block beside them."""
    top_left, top_right, low_left, low_right = own
    top, low = top_left & top_right, low_left & low_right
    left, right = top_left & low_left, top_right & low_right
    # Right and below the other wall must be thicker: of two equal halves side by side one stays.
    at_left = _side((top_left, low_left), (top_right, low_right), (top_right, low_right), (0, 1))
    at_right = _side((top_right, low_right), (top_left, low_left), (top, low), (0, -1))
    above = _side((top_left, top_right), (low_left, low_right), (low_left, low_right), (1, 0))
    below = _side((low_left, low_right), (top_left, top_right), (left, right), (-1, 0))
    # The inner corner of two walls.
    corner = (at_left.edge | at_right.edge) & (above.edge | below.edge) & ~(top & low)
    return at_left.rim | at_right.rim | above.rim | below.rim | corner


class _Side(NamedTuple):
    """Blocks with nothing but a rim at one side of them, and those whose parts all along it go on beyond."""

    rim: Bits
    edge: Bits


def _side(
    at: tuple[Bits, Bits], others: tuple[Bits, Bits], beyond: tuple[Bits, Bits], to: tuple[int, int]
) -> _Side:
    """Return the marks of one side. `at`: the parts there, `others`: those farther in; `beyond`: in the block
    on that side, which lies one step before `to` (down, right), what must be there for a part to go on."""
    (one, two), (down, right) = at, to
    next_one, next_two = _from(beyond[0], down, right), _from(beyond[1], down, right)
    alone = (one | two) & ~(others[0] | others[1])
    rim = alone & (~one | next_one) & (~two | next_two)
    # A thin wall goes on where something stands at it.
    goes_on = alone & ~rim
    for _ in range(REACH):
        goes_on |= alone & (_from(goes_on, right, down) | _from(goes_on, -right, -down))
    return _Side(rim & ~goes_on, one & two & next_one & next_two)


def _from(blocks: Bits, down: int, right: int) -> Bits:
    """Return the blocks moved by at most one, down or right."""
    moved = np.zeros_like(blocks)
    if down > 0:
        moved[1:] = blocks[:-1]
    elif down < 0:
        moved[:-1] = blocks[1:]
    elif right > 0:
        moved = blocks >> np.uint8(1)
        moved[:, 1:] |= blocks[:, :-1] << np.uint8(7)
    elif right < 0:
        moved = blocks << np.uint8(1)
        moved[:, :-1] |= blocks[:, 1:] >> np.uint8(7)
    return moved


def _around(blocks: Bits) -> Bits:
    """Return the blocks and all that touch them."""
    tall = blocks | _from(blocks, 1, 0) | _from(blocks, -1, 0)
    return tall | _from(tall, 0, 1) | _from(tall, 0, -1)
