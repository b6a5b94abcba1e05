"""Commands to robots, and the life of each one from the key to its one end."""

from collections.abc import Mapping
from enum import Enum

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Order, Stop


class PlaceOrder(Struct, frozen=True, tag=True):
    """Carry from the first of the `stops` to the last. To a single one goes the cargo on board, or the robot
    alone where it tells of no cargo."""

    robot: str
    stops: tuple[Stop, ...]

    @property
    def with_cargo(self) -> bool:
        """Tell whether it brings what is on board already."""
        return len(self.stops) == 1

    def what(self, kind: Kind) -> str:
        """Return what is asked of a robot of this kind, in a word or two."""
        return "bring cargo" if self.with_cargo and "cargo" in kind.reports else "order"

    def text(self, kind: Kind, route: str) -> str:
        """Return what is asked, with its stops; `route` are those in words."""
        if self.with_cargo and "cargo" not in kind.reports:
            return f"go to {route.removeprefix('-> ')}"
        return f"{self.what(kind)} {route}"


class CancelOrder(Struct, frozen=True, tag=True):
    """Take one order out of the queue."""

    robot: str
    order_id: str


class ClearOrders(Struct, frozen=True, tag=True):
    """Take every order out of the queue."""

    robot: str


class PauseRobot(Struct, frozen=True, tag=True):
    """Stand still until resumed."""

    robot: str


class ResumeRobot(Struct, frozen=True, tag=True):
    """Go on after a pause."""

    robot: str


Command = PlaceOrder | CancelOrder | ClearOrders | PauseRobot | ResumeRobot


class Stage(Enum):
    """The stage of a command; the value is shown to the operator."""

    CHECKED = "checked"
    WAITING = "waiting here"
    SENT = "sent"
    ACCEPTED = "accepted"
    NO_ANSWER = "no answer"
    UNKNOWN = "outcome unknown"
    REFUSED = "refused"
    NOT_SENT = "not sent"
    CONFIRMED = "confirmed"
    NOT_CONFIRMED = "not confirmed"
    UNVERIFIABLE = "accepted, but no topic shows it"
    LATE = "carried out late"
    DONE = "done"
    CANCELLED = "cancelled"
    CANCELLED_ELSEWHERE = "cancelled elsewhere"
    LOST = "lost"
    FAILED = "failed"
    REPLACED = "replaced"


_SEEN = frozenset({Stage.CONFIRMED, Stage.NOT_CONFIRMED, Stage.UNVERIFIABLE})
ORDER_ENDS = frozenset(
    {
        Stage.DONE,
        Stage.CANCELLED,
        Stage.CANCELLED_ELSEWHERE,
        Stage.LOST,
        Stage.FAILED,
        Stage.REPLACED,
    }
)
"""Ends of an order that was in the queue."""

NEXT: Mapping[Stage, frozenset[Stage]] = {
    Stage.CHECKED: frozenset({Stage.SENT, Stage.NOT_SENT, Stage.WAITING}),
    # An order that this console keeps until the robot is free for it.
    Stage.WAITING: frozenset({Stage.SENT, Stage.NOT_SENT, Stage.CANCELLED}),
    Stage.SENT: frozenset({Stage.ACCEPTED, Stage.REFUSED, Stage.NO_ANSWER, Stage.UNKNOWN}),
    Stage.ACCEPTED: _SEEN,
    # An answer may come late; the link may go while it is waited for.
    Stage.NO_ANSWER: _SEEN | {Stage.ACCEPTED, Stage.REFUSED, Stage.UNKNOWN},
    Stage.UNKNOWN: _SEEN,
    Stage.REFUSED: frozenset(),
    Stage.NOT_SENT: frozenset(),
    # Of an order; a pause can only be lost, and any other command has ended.
    Stage.CONFIRMED: ORDER_ENDS | {Stage.WAITING},
    # A robot that was frozen obeys when it wakes.
    Stage.NOT_CONFIRMED: frozenset({Stage.LATE}),
    Stage.LATE: ORDER_ENDS | {Stage.WAITING},
    Stage.UNVERIFIABLE: frozenset({Stage.LOST}),
    Stage.DONE: frozenset(),
    Stage.CANCELLED: frozenset(),
    Stage.CANCELLED_ELSEWHERE: frozenset(),
    Stage.LOST: frozenset(),
    Stage.FAILED: frozenset(),
    Stage.REPLACED: frozenset(),
}
"""The allowed transitions. A stage without a next one is an end."""

OPEN = frozenset({Stage.CHECKED, Stage.WAITING, Stage.SENT, Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN})
"""Stages in which the outcome of a command is not known yet."""

FAILURES = frozenset(
    {
        Stage.REFUSED,
        Stage.NOT_SENT,
        Stage.NOT_CONFIRMED,
        Stage.LATE,
        Stage.CANCELLED_ELSEWHERE,
        Stage.LOST,
        Stage.FAILED,
        Stage.REPLACED,
    }
)
"""The stages that need a person."""


UNANSWERED = "no reply expected"
"""Words of a command that was published: only telemetry can tell what became of it."""


class Step(Struct, frozen=True):
    """A command reached a stage at `at` (monotonic). `words` are the robot's own, or the reason."""

    stage: Stage
    at: float
    words: str = ""


class Baseline(Struct, frozen=True):
    """The robot's reports when the command was given; telemetry is compared with it.

    `last_serial` is None where no queue had come; `request_id` is the one that the queue echoed.
    `counted` is how far its orders had counted by its own word. `moving`: its pose had just changed. `floor`
    is empty where it was not known."""

    last_serial: int | None = None
    moving: bool = False
    request_id: int = 0
    counted: int = 0
    floor: str = ""


class CommandRecord(Struct, frozen=True):
    """One command from the key to its end. `issued_at` is monotonic, `wall` Unix seconds; `order_id` and
    `order_serial` are those of the order in the robot's queue that a placed one was recognised as; `name` is
    that which this console gave it on the wire, empty where the robot names it. `leg` is the stop that it
    leads to now, of orders whose stops this console gives one after the other. `answer`: what the robot told
    this console of the end of a goal."""

    id: int
    command: Command
    issued_at: float
    wall: float
    steps: tuple[Step, ...]
    before: Baseline
    order_id: str | None = None
    order_serial: int | None = None
    answer: Step | None = None
    name: str = ""
    leg: int = 0

    @property
    def stage(self) -> Stage:
        """Return where it stands."""
        return self.steps[-1].stage

    @property
    def words(self) -> str:
        """Return what was said when it got there."""
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
        return (
            isinstance(self.command, PlaceOrder)
            and self.order_id is not None
            and self.stage in (Stage.CONFIRMED, Stage.LATE)
        )

    @property
    def outcome(self) -> Step | None:
        """The step that decided it, None while it is open. An order that waits here again is open again."""
        waited = max((n for n, step in enumerate(self.steps) if step.stage is Stage.WAITING), default=0)
        return next((step for step in self.steps[waited:] if step.stage not in OPEN), None)

    def has_further_leg(self, kind: Kind) -> bool:
        """Tell whether stops are left that its robot does not know of yet."""
        if not kind.gives_stops or not isinstance(self.command, PlaceOrder):
            return False
        return self.leg + 1 < len(self.command.stops)

    def time_of(self, stage: Stage) -> float | None:
        """When it reached a stage last, None if never."""
        return next((step.at for step in reversed(self.steps) if step.stage is stage), None)

    def advanced(self, step: Step) -> "CommandRecord":
        """The record one step on, or itself where the table does not allow that step."""
        if step.stage not in NEXT[self.stage]:
            return self
        return replace(self, steps=(*self.steps, step))

    def recognised(self, order: Order, step: Step) -> "CommandRecord":
        """The record one step on, with the order that it placed."""
        return replace(self.advanced(step), order_id=order.id, order_serial=order.serial)
