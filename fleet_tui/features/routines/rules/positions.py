"""Positions in the nested blocks of a lane."""

from collections.abc import Mapping
from itertools import pairwise
from typing import assert_never

from fleet_tui.features.routines.blocks import (
    Block,
    CarryBlock,
    GoBlock,
    IfBlock,
    LanePlan,
    Leaf,
    RepeatBlock,
    RunBlock,
    WaitBlock,
)
from fleet_tui.features.routines.lane import Lane, LanePhase, Part, Position

Path = tuple[Position, ...]


def blocks_at(plan: LanePlan, path: Path) -> tuple[Block, ...]:
    """Return the list of blocks that a path ends in. Raises LookupError if the plan has no such path."""
    found = plan.on_failure if path[0].part is Part.FAILURE else plan.body
    for outer, inner in pairwise(path):
        block = found[outer.index]
        found = parts_of(block)[inner.part]
    return found


def parts_of(block: Block) -> Mapping[Part, tuple[Block, ...]]:
    """Return the lists of blocks within a block, none for an instruction."""
    match block:
        case RepeatBlock(body=body):
            return {Part.BODY: body}
        case IfBlock(body=body, otherwise=otherwise):
            return {Part.BODY: body, Part.ELSE: otherwise}
        case GoBlock() | CarryBlock() | WaitBlock() | RunBlock():
            return {}
        case _:
            assert_never(block)


def block_at(plan: LanePlan, path: Path) -> Block | None:
    """Return the block at the end of a path, None after the last one of its list."""
    blocks, index = blocks_at(plan, path), path[-1].index
    return blocks[index] if index < len(blocks) else None


def fits(plan: LanePlan, lane: Lane) -> bool:
    """Tell whether a lane that was kept can go on in a plan: an older version may have read the same file in
    another way."""
    indexes = [one.index for one in lane.path]
    try:
        block = block_at(plan, lane.path)
    except LookupError:
        return False
    is_order = isinstance(block, GoBlock | CarryBlock)
    return min(indexes) >= 0 and (is_order or lane.phase is not LanePhase.ORDERED)


def leaf_at(plan: LanePlan, path: Path) -> Leaf:
    """Return the instruction at the end of a path, which has one while it is carried out."""
    block = block_at(plan, path)
    assert isinstance(block, Leaf)
    return block


def after(path: Path) -> Path:
    """Return the path to the next block of the same list."""
    last = path[-1]
    return (*path[:-1], Position(last.part, last.index + 1, last.round))


def again(path: Path) -> Path:
    """Return the path to the first block of the next round."""
    last = path[-1]
    return (*path[:-1], Position(last.part, 0, last.round + 1))
