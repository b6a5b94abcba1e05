"""What an operator may ask of a robot, and the life of each wish, from the key to its one end."""

from collections.abc import Mapping, Sequence
from enum import Enum
from itertools import pairwise

from msgspec import Struct, field
from msgspec.structs import replace

INT32_MAX = 2**31 - 1


class PlaceOrder(Struct, frozen=True, tag=True):
    """Carry from vertex `start` to vertex `end`."""

    robot: str
    start: int
    end: int


class PlaceOrderWithCargo(Struct, frozen=True, tag=True):
    """Bring the cargo on board to vertex `end`."""

    robot: str
    end: int


class CancelOrder(Struct, frozen=True, tag=True):
    """Take one order out of the queue. `order_id` is above 0: 0 would mean all of them."""

    robot: str
    order_id: int


class ClearOrders(Struct, frozen=True, tag=True):
    """Take every order out of the queue."""

    robot: str


class PauseRobot(Struct, frozen=True, tag=True):
    """Stand still until resumed."""

    robot: str


class ResumeRobot(Struct, frozen=True, tag=True):
    """Go on after a pause."""

    robot: str


Command = PlaceOrder | PlaceOrderWithCargo | CancelOrder | ClearOrders | PauseRobot | ResumeRobot


class Wish(Struct, frozen=True):
    """What an operator asks in one go: commands in sequence. `floors`: the floor of each vertex that
    was chosen by name, since the wire knows only ids, and floors may have the same ones."""

    commands: tuple[Command, ...]
    floors: Mapping[int, str] = field(default_factory=dict)


def chain(robot: str, vertices: Sequence[int], with_cargo: bool = False) -> tuple[Command, ...]:
    """Orders that visit the vertices one after the other: A, B, C is A -> B and B -> C. `with_cargo`:
    what is on board goes to the first one."""
    first = [PlaceOrderWithCargo(robot, vertices[0])] if with_cargo else []
    return (*first, *(PlaceOrder(robot, start, end) for start, end in pairwise(vertices)))


class Stage(Enum):
    """Where a command stands; the value is what the operator reads."""

    CHECKED = "checked"
    SENT = "sent"
    ACCEPTED = "accepted"
    NO_ANSWER = "no answer"
    UNKNOWN = "outcome unknown"
    REFUSED = "refused"
    NOT_SENT = "not sent"
    CONFIRMED = "confirmed"
    NOT_CONFIRMED = "not confirmed"
    TAKEN = "accepted, but no topic shows it"
    LATE = "carried out late"
    DONE = "done"
    CANCELLED = "cancelled"
    CANCELLED_ELSEWHERE = "cancelled elsewhere"
    LOST = "lost"


_SEEN = frozenset({Stage.CONFIRMED, Stage.NOT_CONFIRMED, Stage.TAKEN})
ORDER_ENDS = frozenset({Stage.DONE, Stage.CANCELLED, Stage.CANCELLED_ELSEWHERE, Stage.LOST})
"""Ends of an order that was in the queue."""

NEXT: Mapping[Stage, frozenset[Stage]] = {
    Stage.CHECKED: frozenset({Stage.SENT, Stage.NOT_SENT}),
    Stage.SENT: frozenset({Stage.ACCEPTED, Stage.REFUSED, Stage.NO_ANSWER, Stage.UNKNOWN}),
    Stage.ACCEPTED: _SEEN,
    # An answer may come late; the link may go while it is waited for.
    Stage.NO_ANSWER: _SEEN | {Stage.ACCEPTED, Stage.REFUSED, Stage.UNKNOWN},
    Stage.UNKNOWN: _SEEN,
    Stage.REFUSED: frozenset(),
    Stage.NOT_SENT: frozenset(),
    # Of an order; a pause can only be lost, and any other command has ended.
    Stage.CONFIRMED: ORDER_ENDS,
    # A robot that was frozen obeys when it wakes.
    Stage.NOT_CONFIRMED: frozenset({Stage.LATE}),
    Stage.LATE: ORDER_ENDS,
    Stage.TAKEN: frozenset({Stage.LOST}),
    Stage.DONE: frozenset(),
    Stage.CANCELLED: frozenset(),
    Stage.CANCELLED_ELSEWHERE: frozenset(),
    Stage.LOST: frozenset(),
}
"""The allowed transitions. A stage without a next one is an end."""

OPEN = frozenset({Stage.CHECKED, Stage.SENT, Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN})
"""Stages in which the outcome of a command is not known yet."""

FAILURES = frozenset(
    {Stage.REFUSED, Stage.NOT_SENT, Stage.NOT_CONFIRMED, Stage.LATE, Stage.CANCELLED_ELSEWHERE, Stage.LOST}
)
"""The stages that need a person."""


class Step(Struct, frozen=True):
    """A command reached a stage at `at` (monotonic). `words` are the robot's own, or the reason."""

    stage: Stage
    at: float
    words: str = ""


class Before(Struct, frozen=True):
    """What the robot had reported when the command was given: telemetry is read against it.

    `last_order_id` is None where no queue had come; `request_id` is the one that the queue echoed.
    `counted` is how far its order ids had counted by its own word. `moving`: its pose had just changed."""

    last_order_id: int | None = None
    moving: bool = False
    request_id: int = 0
    counted: int = 0


class CommandRecord(Struct, frozen=True):
    """One command from the key to its end. `issued_at` is monotonic, `wall` Unix seconds; `order_id`
    is the order in the robot's queue that a placed one was recognised as."""

    id: int
    command: Command
    issued_at: float
    wall: float
    steps: tuple[Step, ...]
    before: Before
    order_id: int | None = None

    @property
    def stage(self) -> Stage:
        """Where it stands."""
        return self.steps[-1].stage

    @property
    def words(self) -> str:
        """What was said when it got there."""
        return self.steps[-1].words

    @property
    def at(self) -> float:
        """Since when it stands there (monotonic)."""
        return self.steps[-1].at

    @property
    def is_decided(self) -> bool:
        """Tell whether its outcome is known. An order lives on after that, until it is done or gone."""
        return self.stage not in OPEN

    @property
    def has_open_order(self) -> bool:
        """Tell whether the order that it placed is in the robot's queue, as far as is known."""
        places = isinstance(self.command, PlaceOrder | PlaceOrderWithCargo)
        return places and self.order_id is not None and self.stage in (Stage.CONFIRMED, Stage.LATE)

    @property
    def outcome(self) -> Step | None:
        """The step that decided it, None while it is open."""
        return next((step for step in self.steps if step.stage not in OPEN), None)

    def time_of(self, stage: Stage) -> float | None:
        """When it reached a stage last, None if never."""
        return next((step.at for step in reversed(self.steps) if step.stage is stage), None)

    def advanced(self, step: Step) -> "CommandRecord":
        """The record one step on, or itself where the table does not allow that step."""
        if step.stage not in NEXT[self.stage]:
            return self
        return replace(self, steps=(*self.steps, step))
