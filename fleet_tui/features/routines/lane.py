"""The progress of one robot through its part of a routine, the events that change it, and their effects."""

from collections.abc import Callable
from enum import Enum

from msgspec import Struct

from fleet_tui.features.routines.blocks import CarryBlock, Condition, DayTime, GoBlock, RunBlock
from fleet_tui.text.language import EMPTY, N_, Message


class LanePhase(Enum):
    """The activity of a lane. READY: its next instruction has not begun."""

    READY = N_("ready")
    WAITING = N_("waiting")
    ORDERED = N_("running an order")
    PROGRAM = N_("running a program")
    DONE = N_("done")
    FAILED = N_("failed")
    STOPPED = N_("stopped")


LANE_ENDS = frozenset({LanePhase.DONE, LanePhase.FAILED, LanePhase.STOPPED})


class Gate(Enum):
    """Permission to begin instructions. STEP: one, then PAUSED. HELD: none before a person resumes."""

    OPEN = N_("open")
    STEP = N_("step")
    PAUSED = N_("paused")
    HELD = N_("held")


class Part(Enum):
    """A list of blocks: of a lane, a repeat or an if; its `else`; the `on failure` of a lane."""

    BODY = N_("body")
    ELSE = N_("else")
    FAILURE = N_("on failure")


class Position(Struct, frozen=True):
    """The place in one list of blocks: `index` of the current one, and the number of rounds before this
    one."""

    part: Part = Part.BODY
    index: int = 0
    round: int = 0


class Lane(Struct, frozen=True):
    """The progress of a robot. `path`: positions from the lane's own blocks to the innermost ones; `until`:
    Unix seconds at which a wait ends, if it is one for a time; `detail`: the reason of the last failure or
    hold; `since`: Unix seconds of the last change; `order_id`: of the order that runs, as far as known."""

    robot: str
    path: tuple[Position, ...] = (Position(),)
    phase: LanePhase = LanePhase.READY
    gate: Gate = Gate.OPEN
    until: float = 0.0
    detail: Message = EMPTY
    since: float = 0.0
    order_id: str = ""

    @property
    def is_over(self) -> bool:
        """Tell whether nothing follows any more."""
        return self.phase in LANE_ENDS

    @property
    def has_failed(self) -> bool:
        """Tell whether an instruction has failed: it carries out what follows a failure."""
        return self.path[0].part is Part.FAILURE or self.phase is LanePhase.FAILED


class LaneFacts(Struct, frozen=True):
    """The world at a moment. `wall`: Unix seconds; `no_link`: the reason that commands do not reach the
    robot, empty if they do; `holds` tells whether a condition holds, None if that is unknown; `next_time`
    returns the Unix second at which the local clock next shows a time."""

    wall: float
    no_link: Message
    holds: Callable[[Condition], bool | None]
    next_time: Callable[[DayTime], float]


class Ticked(Struct, frozen=True):
    """Time has passed."""

    facts: LaneFacts


class OrderEnded(Struct, frozen=True):
    """The outcome of an order is known."""

    is_done: bool
    words: Message = EMPTY


class OrderWithheld(Struct, frozen=True):
    """An order was not sent, for a reason that a person can remove."""

    words: Message


class ProgramEnded(Struct, frozen=True):
    """A program has ended; `is_done`: with exit code 0."""

    is_done: bool
    words: Message = EMPTY


class LanePaused(Struct, frozen=True):
    """A person lets nothing follow for now."""


class LaneResumed(Struct, frozen=True):
    """A person lets the lane go on."""


class LaneStepped(Struct, frozen=True):
    """A person lets one instruction follow."""


class LaneSkipped(Struct, frozen=True):
    """A person lets the lane go on after the next instruction."""


class LaneStopped(Struct, frozen=True):
    """A person ends the lane."""


LaneRequest = LanePaused | LaneResumed | LaneStepped | LaneSkipped | LaneStopped
LaneEvent = Ticked | OrderEnded | OrderWithheld | ProgramEnded | LaneRequest


class GiveOrder(Struct, frozen=True):
    """Give the order of a block."""

    block: GoBlock | CarryBlock


class StartProgram(Struct, frozen=True):
    """Start the program of a block."""

    block: RunBlock


class EndProgram(Struct, frozen=True):
    """End the program that runs."""


class LaneNote(Struct, frozen=True):
    """A line for people: `change` of the block in a `line`, or of the lane if that is 0."""

    change: Message
    line: int = 0
    text: str = ""
    detail: Message = EMPTY


LaneAction = GiveOrder | StartProgram | EndProgram | LaneNote

BEGUN = Message("begun")
ENDED = Message("done")
LEFT = Message("not done")
SKIPPED = Message("skipped")
"""Changes of a block: it was carried out, left after a failure or a stop, or not begun."""
