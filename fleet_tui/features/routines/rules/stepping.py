"""The life of a lane as a table: by its phase and an event, the next lane and its effects.

Each block that begins ends exactly once, whatever fails. Without a link nothing follows: the lane is held
until a person resumes it, while the outcome of a running order or program is still taken.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, assert_never

from msgspec.structs import replace

from fleet_tui.features.routines.blocks import (
    CarryBlock,
    Condition,
    DayTime,
    GoBlock,
    IfBlock,
    LanePlan,
    RepeatBlock,
    RunBlock,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.features.routines.lane import (
    BEGUN,
    ENDED,
    LEFT,
    SKIPPED,
    EndProgram,
    Gate,
    GiveOrder,
    Lane,
    LaneAction,
    LaneEvent,
    LaneFacts,
    LaneNote,
    LanePaused,
    LanePhase,
    LaneResumed,
    LaneSkipped,
    LaneStepped,
    LaneStopped,
    OrderEnded,
    OrderWithheld,
    Part,
    Position,
    ProgramEnded,
    StartProgram,
    Ticked,
)
from fleet_tui.features.routines.rules.positions import after, again, block_at, leaf_at
from fleet_tui.text.language import EMPTY, Message

MOST_MOVES = 100
"""Blocks begun or ended by one tick: an endless repeat must not stop the console."""

Stepped = tuple[Lane, list[LaneAction]]


def step(plan: LanePlan, lane: Lane, event: LaneEvent) -> Stepped:
    """Return the lane after an event, and its effects in sequence. An event that has no place in the table
    changes nothing."""
    handler = TABLE.get((lane.phase, type(event)))
    return handler(plan, lane, event) if handler else (lane, [])


def _tick(plan: LanePlan, lane: Lane, event: Ticked) -> Stepped:
    """Hold a lane without a link, else begin instructions, or end a wait."""
    if event.facts.no_link and lane.gate is not Gate.HELD:
        return _hold(lane, event.facts.no_link)
    if lane.gate in (Gate.PAUSED, Gate.HELD):
        return lane, []
    if lane.phase is LanePhase.READY:
        return _begin(plan, lane, event.facts)
    return _wait(plan, lane, event.facts) if lane.phase is LanePhase.WAITING else (lane, [])


def _begin(plan: LanePlan, lane: Lane, facts: LaneFacts) -> Stepped:
    """Begin the next instruction, with the blocks around it."""
    actions: list[LaneAction] = []
    for _ in range(MOST_MOVES):
        block = block_at(plan, lane.path)
        match block:
            case None if len(lane.path) == 1:
                ended = LanePhase.FAILED if lane.has_failed else LanePhase.DONE
                note = LaneNote(Message(ended.value), detail=lane.detail)
                return replace(lane, phase=ended), [*actions, note]
            case None:
                lane, notes = _next_round(plan, lane)
                actions += notes
            case RepeatBlock():
                actions.append(LaneNote(BEGUN, block.line, block.text))
                lane = replace(lane, path=(*lane.path, Position()))
            case IfBlock():
                if (holds := facts.holds(block.condition)) is None:
                    failed, more = _fail(plan, lane, Message("{text}: unknown", text=block.text))
                    return failed, actions + more
                actions.append(LaneNote(BEGUN, block.line, block.text))
                lane = replace(lane, path=(*lane.path, Position(Part.BODY if holds else Part.ELSE)))
            case GoBlock() | CarryBlock() | WaitBlock() | RunBlock():
                begun, more = _begin_leaf(lane, block, facts)
                return begun, [*actions, LaneNote(BEGUN, block.line, block.text), *more]
            case _:
                assert_never(block)
    return lane, actions


def _next_round(plan: LanePlan, lane: Lane) -> tuple[Lane, list[LaneNote]]:
    """Return the lane at the next round of the innermost block, or after it."""
    outer = lane.path[:-1]
    block = block_at(plan, outer)
    assert block is not None
    if isinstance(block, RepeatBlock) and (block.times is None or lane.path[-1].round + 1 < block.times):
        return replace(lane, path=again(lane.path)), []
    return replace(lane, path=after(outer)), [LaneNote(ENDED, block.line, block.text)]


def _begin_leaf(
    lane: Lane, block: GoBlock | CarryBlock | WaitBlock | RunBlock, facts: LaneFacts
) -> tuple[Lane, list[LaneAction]]:
    lane = replace(lane, detail=lane.detail if lane.has_failed else EMPTY, order_id="")
    match block:
        case WaitBlock(until=TimeSpan(seconds)):
            return replace(lane, phase=LanePhase.WAITING, until=facts.wall + seconds), []
        case WaitBlock(until=DayTime() as at):
            return replace(lane, phase=LanePhase.WAITING, until=facts.next_time(at)), []
        case WaitBlock():
            return replace(lane, phase=LanePhase.WAITING, until=0.0), []
        case RunBlock():
            return replace(lane, phase=LanePhase.PROGRAM), [StartProgram(block)]
        case GoBlock() | CarryBlock():
            return replace(lane, phase=LanePhase.ORDERED), [GiveOrder(block)]
        case _:
            assert_never(block)


def _wait(plan: LanePlan, lane: Lane, facts: LaneFacts) -> Stepped:
    block = leaf_at(plan, lane.path)
    assert isinstance(block, WaitBlock)
    return _finished(plan, lane) if _is_over(block.until, lane, facts) else (lane, [])


def _is_over(until: TimeSpan | DayTime | Condition, lane: Lane, facts: LaneFacts) -> bool:
    if isinstance(until, TimeSpan | DayTime):
        return facts.wall >= lane.until
    return facts.holds(until) is True


def _finished(plan: LanePlan, lane: Lane) -> Stepped:
    """Return the lane after the instruction that has just ended."""
    block = leaf_at(plan, lane.path)
    gate = Gate.PAUSED if lane.gate is Gate.STEP else lane.gate
    ended = replace(lane, phase=LanePhase.READY, gate=gate, path=after(lane.path))
    return ended, [LaneNote(ENDED, block.line, block.text)]


def _outcome(plan: LanePlan, lane: Lane, event: OrderEnded | ProgramEnded) -> Stepped:
    """Go on after an order or a program. One that failed while the lane is held is for a person to decide."""
    if event.is_done:
        return _finished(plan, lane)
    if lane.gate is not Gate.HELD:
        return _fail(plan, lane, event.words)
    block = leaf_at(plan, lane.path)
    held = replace(lane, phase=LanePhase.READY, detail=event.words)
    return held, [LaneNote(LEFT, block.line, block.text, event.words)]


def _withheld(plan: LanePlan, lane: Lane, event: OrderWithheld) -> Stepped:
    block = leaf_at(plan, lane.path)
    left = LaneNote(LEFT, block.line, block.text)
    held, actions = _hold(replace(lane, phase=LanePhase.READY), event.words)
    return held, [left, *actions]


def _hold(lane: Lane, reason: Message) -> Stepped:
    return replace(lane, gate=Gate.HELD, detail=reason), [LaneNote(Message(Gate.HELD.value), detail=reason)]


def _left(plan: LanePlan, lane: Lane, detail: Message) -> Iterator[LaneNote]:
    """Yield the ends of all open blocks, the innermost first."""
    depth = len(lane.path) - (lane.phase is LanePhase.READY)
    for length in range(depth, 0, -1):
        block = block_at(plan, lane.path[:length])
        assert block is not None
        yield LaneNote(LEFT, block.line, block.text, detail)


def _fail(plan: LanePlan, lane: Lane, reason: Message) -> Stepped:
    """Leave every block, and begin those for a failure, once."""
    actions: list[LaneAction] = [*_left(plan, lane, reason)]
    if lane.has_failed or not plan.on_failure:
        detail = (
            Message("{detail}; then {reason}", detail=lane.detail, reason=reason)
            if lane.has_failed
            else reason
        )
        failed = replace(lane, phase=LanePhase.FAILED, path=lane.path[:1], detail=detail)
        return failed, [*actions, LaneNote(Message(LanePhase.FAILED.value), detail=detail)]
    path = (Position(Part.FAILURE),)
    gate = Gate.PAUSED if lane.gate is Gate.STEP else lane.gate
    failed = replace(lane, phase=LanePhase.READY, path=path, gate=gate, detail=reason)
    return failed, [*actions, LaneNote(Message(Part.FAILURE.value), detail=reason)]


def _pause(plan: LanePlan, lane: Lane, event: LanePaused) -> Stepped:
    if lane.gate in (Gate.PAUSED, Gate.HELD):
        return lane, []
    return replace(lane, gate=Gate.PAUSED), [LaneNote(Message(Gate.PAUSED.value))]


def _resume(plan: LanePlan, lane: Lane, event: LaneResumed) -> Stepped:
    if lane.gate is Gate.OPEN:
        return lane, []
    return replace(lane, gate=Gate.OPEN), [LaneNote(Message("resumed"))]


def _step(plan: LanePlan, lane: Lane, event: LaneStepped) -> Stepped:
    return replace(lane, gate=Gate.STEP), [LaneNote(Message("step"))]


def _skip(plan: LanePlan, lane: Lane, event: LaneSkipped) -> Stepped:
    """Go on after the next instruction. Only while nothing runs, and there is one."""
    block = block_at(plan, lane.path)
    if lane.gate in (Gate.OPEN, Gate.STEP) or block is None:
        return lane, []
    skipped = replace(lane, path=after(lane.path), gate=Gate.OPEN)
    return skipped, [LaneNote(SKIPPED, block.line, block.text)]


def _stop(plan: LanePlan, lane: Lane, event: LaneStopped) -> Stepped:
    """Leave every block. A running order goes on: it is the robot's; a program is ended."""
    runs = lane.phase is LanePhase.PROGRAM
    actions: list[LaneAction] = [*([EndProgram()] if runs else []), *_left(plan, lane, Message("stopped"))]
    stopped = replace(lane, phase=LanePhase.STOPPED, path=lane.path[:1])
    return stopped, [*actions, LaneNote(Message(LanePhase.STOPPED.value))]


_BUSY = (LanePhase.WAITING, LanePhase.ORDERED, LanePhase.PROGRAM)
_ALIVE = (LanePhase.READY, *_BUSY)

TABLE: Mapping[tuple[LanePhase, type[LaneEvent]], Callable[[LanePlan, Lane, Any], Stepped]] = {
    **{(phase, Ticked): _tick for phase in _ALIVE},
    **{(phase, LanePaused): _pause for phase in _ALIVE},
    **{(phase, LaneResumed): _resume for phase in _ALIVE},
    **{(phase, LaneStepped): _step for phase in _ALIVE},
    **{(phase, LaneStopped): _stop for phase in _ALIVE},
    (LanePhase.READY, LaneSkipped): _skip,
    (LanePhase.ORDERED, OrderEnded): _outcome,
    (LanePhase.ORDERED, OrderWithheld): _withheld,
    (LanePhase.PROGRAM, ProgramEnded): _outcome,
}
