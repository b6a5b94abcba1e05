"""Walls at the scale of the picture: thin ones stay, and narrow ways between them stay open."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from fleet_tui.view.map.tracing import Mask

REACH = 2
"""Blocks from which a thin wall goes on along the rim of another."""
Blocks = NDArray[np.uint8]
"""Blocks, the walls in their parts as bits."""
RIM = REACH + 2
"""Blocks beside a block that decide on it."""


_ALONE, _RIM, _EDGE = 1, 2, 4
_TOP_LEFT, _TOP_RIGHT, _LOW_LEFT, _LOW_RIGHT = 1, 2, 4, 8


def _table(pairs: tuple[tuple[int, int], tuple[int, int]], wins: bool) -> NDArray[np.uint8]:
    """Return marks for each block (its parts as bits, times 16) with each block on one side of it. `pairs`:
    parts at that side, each with the part beyond it; `wins`: of two equal halves side by side this is the
    wall.

    alone: the block has parts only at that side; rim: so has it, and they go on beyond; edge: parts all along
    that side go on beyond."""
    (one, _), (two, _) = pairs
    marks = np.zeros(256, np.uint8)
    for own in range(1, 16):
        for other in range(16):
            goes_on = [
                # Where this one wins the other must be thicker.
                bool(other & beyond) and (not wins or bool(other & part))
                for part, beyond in pairs
                if own & part
            ]
            is_alone = not own & ~(one | two)
            is_edge = len(goes_on) == 2 and all(goes_on)
            marks[own * 16 + other] = _ALONE * is_alone + _RIM * (is_alone and all(goes_on)) + _EDGE * is_edge
    return marks


_LEFT = _table(((_TOP_LEFT, _TOP_RIGHT), (_LOW_LEFT, _LOW_RIGHT)), False)
_RIGHT = _table(((_TOP_RIGHT, _TOP_LEFT), (_LOW_RIGHT, _LOW_LEFT)), True)
_ABOVE = _table(((_TOP_LEFT, _LOW_LEFT), (_TOP_RIGHT, _LOW_RIGHT)), False)
_BELOW = _table(((_LOW_LEFT, _TOP_LEFT), (_LOW_RIGHT, _TOP_RIGHT)), True)
_SIDES = (_LEFT, 0, 1), (_RIGHT, 0, -1), (_ABOVE, 1, 0), (_BELOW, -1, 0)


def wall_blocks(parts: Mask, ways: Mask | None = None) -> Mask:
    """Return the blocks that are drawn as wall. `parts`: the walls, in 2 x 2 parts for each block; `ways`:
    the parts in which robots drive.

    A block is wall where it contains some, unless that is less than its half and the rim of a wall that is
    drawn beside it: walls are as thick as they are, not thicker by up to a block on each side. So is a block
    free if robots drive in it past its wall. But no wall vanishes: each is drawn in its block or in one that
    touches it.
    """
    blocks = _packed(parts)
    walls, kept = blocks > 0, blocks
    if ways is not None:
        passed = _packed(ways)
        kept = blocks * ((passed == 0) | (passed & blocks > 0))
    drawn = (kept > 0) & ~_rims(kept)
    return np.asarray(drawn | (walls & ~_around(drawn)))


def _packed(parts: Mask) -> Blocks:
    """Return the parts of each block as bits."""
    bits = parts.view(np.uint8)
    tall = bits[0::2] + bits[1::2] * np.uint8(_LOW_LEFT)
    return np.asarray(tall[:, 0::2] + tall[:, 1::2] * np.uint8(_TOP_RIGHT), np.uint8)


def _rims(blocks: Blocks) -> Mask:
    """Return the blocks with nothing but the rim of the wall in a block beside them."""
    found = np.zeros(blocks.shape, np.bool_)
    edges = []
    for table, down, right in _SIDES:
        marks = table[blocks * np.uint8(16) + _from(blocks, down, right)]
        # A thin wall goes on where something stands at it.
        alone, goes_on = marks & _ALONE > 0, marks & (_ALONE | _RIM) == _ALONE
        for _ in range(REACH):
            goes_on |= alone & (_from(goes_on, right, down) | _from(goes_on, -right, -down))
        found |= (marks & _RIM > 0) & ~goes_on
        edges.append(marks & _EDGE > 0)
    left, right_edge, above, below = edges
    # The inner corner of two walls.
    return np.asarray(found | ((left | right_edge) & (above | below) & (blocks < 15)))


def _from(blocks: NDArray[Any], down: int, right: int) -> NDArray[Any]:
    """Return the blocks moved down and right."""
    moved = np.zeros_like(blocks)
    rows, columns = blocks.shape[-2:]
    (to_y, of_y), (to_x, of_x) = _slices(down, rows), _slices(right, columns)
    moved[..., to_y, to_x] = blocks[..., of_y, of_x]
    return moved


def _slices(step: int, size: int) -> tuple[slice, slice]:
    """Return the places of a row of this size after a step, and before."""
    after, before = slice(max(step, 0), size + min(step, 0)), slice(max(-step, 0), size - max(step, 0))
    return after, before


def _around(blocks: Mask) -> Mask:
    """Return the blocks and all that touch them."""
    tall = blocks | _from(blocks, 1, 0) | _from(blocks, -1, 0)
    return np.asarray(tall | _from(tall, 0, 1) | _from(tall, 0, -1))
