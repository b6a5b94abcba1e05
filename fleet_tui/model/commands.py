"""Commands to robots, and the life cycle of each from the key to its single end."""

from collections.abc import Mapping
from enum import Enum
from typing import NamedTuple, assert_never

from msgspec import Struct, field
from msgspec.structs import replace

from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Order, Stop
from fleet_tui.model.set_up.commands import SetUp, SetUpCommand, StartCharging
from fleet_tui.text.language import EMPTY, N_, Message


class PlaceOrder(Struct, frozen=True, tag=True):
    """An order from the first of the `stops` to the last. A single one is the destination of the cargo on
    board, or of the robot alone if it reports no cargo. `to_any`: the dispatcher of this robot's fleets
    chooses the robot, which then replaces this one."""

    robot: str
    stops: tuple[Stop, ...]
    to_any: bool = False

    @property
    def with_cargo(self) -> bool:
        """Tell whether it carries the cargo that is on board already."""
        return len(self.stops) == 1

    def what(self, kind: Kind) -> str:
        """Return the name of the command for a robot of this kind, in a word or two."""
        return N_("bring cargo") if self.with_cargo and kind.brings_cargo else N_("order")

    def text(self, kind: Kind, route: str) -> Message:
        """Return the name of the command with its stops; `route` is their text."""
        if self.to_any:
            return Message("order {route} (any robot)", route=route)
        if self.with_cargo and not kind.brings_cargo:
            return Message("go to {place}", place=route.removeprefix("-> "))
        return Message("{what} {route}", what=Message(self.what(kind)), route=route)


class CancelOrder(Struct, frozen=True, tag=True):
    """Remove one order from the queue."""

    robot: str
    order_id: str


class ClearOrders(Struct, frozen=True, tag=True):
    """Remove every order from the queue."""

    robot: str


class PauseRobot(Struct, frozen=True, tag=True):
    """Stop until resumed."""

    robot: str


class ResumeRobot(Struct, frozen=True, tag=True):
    """Continue after a pause."""

    robot: str


Command = PlaceOrder | CancelOrder | ClearOrders | PauseRobot | ResumeRobot | SetUp
Queued = PlaceOrder | StartCharging
"""Commands that may wait in this console's queue."""


def command_name(command: Command, kind: Kind) -> str:
    """Return the name of a command to a robot of this kind, as the audit log has it."""
    match command:
        case PlaceOrder(_, _, to_any):
            return "order any" if to_any else command.what(kind)
        case CancelOrder():
            return "cancel"
        case ClearOrders():
            return "clear"
        case PauseRobot():
            return "pause"
        case ResumeRobot():
            return "resume"
        case SetUpCommand():
            return command.what if command.place else command.text
        case _:
            assert_never(command)


class Stage(Enum):
    """The stage of a command; the value is shown to the operator."""

    CHECKED = N_("checked")
    WAITING = N_("waiting here")
    SENT = N_("sent")
    ACCEPTED = N_("accepted")
    NO_ANSWER = N_("no answer")
    UNKNOWN = N_("outcome unknown")
    REFUSED = N_("refused")
    NOT_SENT = N_("not sent")
    CONFIRMED = N_("confirmed")
    NOT_CONFIRMED = N_("not confirmed")
    UNVERIFIABLE = N_("accepted, but no topic shows it")
    LATE = N_("carried out late")
    DONE = N_("done")
    CANCELLED = N_("cancelled")
    CANCELLED_ELSEWHERE = N_("cancelled elsewhere")
    LEFT = N_("left the queue")
    LOST = N_("lost")
    FAILED = N_("failed")
    REPLACED = N_("replaced")


class Tally(Enum):
    """The column of a shift that counts an order; the value is the part of its name in a metric."""

    DONE = "done"
    LOST = Message("lost or failed")
    LEFT = "left the queue"
    CANCELLED = "cancelled"


class OrderEnd(NamedTuple):
    """An end of an order that was in the queue. `over` is its verb once it is no longer news, empty if it
    needs no person; `remedy` is what to do, empty for that of the alarm's class; `is_inferred`: no report
    states it, so that a later one may correct it."""

    tally: Tally
    over: str = ""
    remedy: Message = EMPTY
    is_inferred: bool = False


CHECK_DELIVERY = Message(
    "Check where the robot and its load are, correct its pose if it is wrong, order again"
)
"""The only remedy that advises to repeat the order: nothing else carries it out."""
ORDER_ENDS: Mapping[Stage, OrderEnd] = {
    Stage.DONE: OrderEnd(Tally.DONE),
    Stage.CANCELLED: OrderEnd(Tally.CANCELLED),
    Stage.CANCELLED_ELSEWHERE: OrderEnd(
        Tally.CANCELLED,
        N_("was cancelled elsewhere"),
        Message("Ask who cancelled it before you order anything else"),
    ),
    Stage.LEFT: OrderEnd(
        Tally.LEFT,
        N_("left the queue"),
        Message("Ask who removed it, and check where the robot and its load are"),
        True,
    ),
    Stage.LOST: OrderEnd(Tally.LOST, N_("was lost"), CHECK_DELIVERY, True),
    Stage.FAILED: OrderEnd(Tally.LOST, N_("failed")),
    Stage.REPLACED: OrderEnd(
        Tally.CANCELLED,
        N_("was replaced"),
        Message("Ask who gave the newer order before you order anything else"),
    ),
}
"""Ends of an order that was in the queue: alarm, `w`, row, history, report and metrics read them here."""
_REPORTED = frozenset(stage for stage, end in ORDER_ENDS.items() if not end.is_inferred)
RESTARTED = Message("this console was restarted")
"""Reason of an order that waits again: a later run of its console has taken it over."""
NOT_LEFT = frozenset({Stage.CHECKED, Stage.WAITING, Stage.NOT_SENT})
"""Stages of a command that has not left this console."""
_SEEN = frozenset({Stage.CONFIRMED, Stage.NOT_CONFIRMED, Stage.UNVERIFIABLE})

NEXT: Mapping[Stage, frozenset[Stage]] = {
    Stage.CHECKED: frozenset({Stage.SENT, Stage.NOT_SENT, Stage.WAITING}),
    # An order that this console keeps until the robot is free for it; it may be moved in its queue.
    Stage.WAITING: frozenset({Stage.WAITING, Stage.SENT, Stage.NOT_SENT, Stage.CANCELLED}),
    # A bridge that does not allow a call drops it, and does not say so.
    Stage.SENT: frozenset({Stage.ACCEPTED, Stage.REFUSED, Stage.NO_ANSWER, Stage.UNKNOWN, Stage.NOT_SENT}),
    Stage.ACCEPTED: _SEEN | {Stage.REFUSED, Stage.CANCELLED},  # a dispatcher looks for a robot after that
    # An answer may be late; the link may go down meanwhile.
    Stage.NO_ANSWER: _SEEN | {Stage.ACCEPTED, Stage.REFUSED, Stage.UNKNOWN, Stage.NOT_SENT},
    Stage.UNKNOWN: _SEEN,
    Stage.REFUSED: frozenset(),
    Stage.NOT_SENT: frozenset(),
    # Only for orders; a pause can only be lost, and any other command has ended.
    Stage.CONFIRMED: frozenset({*ORDER_ENDS, Stage.WAITING}),
    # A robot that was frozen carries out commands when it resumes.
    Stage.NOT_CONFIRMED: frozenset({Stage.LATE}),
    Stage.LATE: frozenset({*ORDER_ENDS, Stage.WAITING}),
    Stage.UNVERIFIABLE: frozenset({Stage.LOST}),
    Stage.DONE: frozenset(),
    Stage.CANCELLED: frozenset(),
    # Known from the other console alone: the robot's own report stands.
    Stage.CANCELLED_ELSEWHERE: frozenset({Stage.DONE, Stage.FAILED, Stage.REPLACED}),
    # Inferred from a queue: corrected by a report, by what another console did, or as it is listed again.
    Stage.LEFT: _REPORTED | {Stage.CONFIRMED},
    Stage.LOST: _REPORTED | {Stage.CONFIRMED},
    Stage.FAILED: frozenset(),
    Stage.REPLACED: frozenset(),
}
"""The allowed transitions. A stage without a next one is final."""
CORRECTABLE = frozenset(stage for stage in ORDER_ENDS if NEXT[stage])
"""Ends of an order that a later report may correct."""

OPEN = frozenset({Stage.CHECKED, Stage.WAITING, Stage.SENT, Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN})
"""Stages in which the outcome of a command is still unknown."""

FAILURES = frozenset(
    {
        Stage.REFUSED,
        Stage.NOT_SENT,
        Stage.NOT_CONFIRMED,
        Stage.LATE,
        *(stage for stage, end in ORDER_ENDS.items() if end.over),
    }
)
"""The stages that need a person."""


UNANSWERED = Message("no reply expected")
"""Reason of a command that was published: only telemetry can show its result."""


class Step(Struct, frozen=True):
    """The stage that a command reached at `at` (monotonic). `detail` are the robot's own, or the reason."""

    stage: Stage
    at: float
    detail: Message = field(default=EMPTY, name="words")  # as recordings have it


class Baseline(Struct, frozen=True):
    """The robot's reports at the time of the command; telemetry is compared with it.

    `last_serial` is None before the first queue; `request_id` is the one that the queue echoed. `counted` is
    the robot's own count of its orders. `moving`: its pose had just changed. `floor` is empty if it was
    unknown.
    """

    last_serial: int | None = None
    moving: bool = False
    request_id: int = 0
    counted: int = 0
    floor: str = ""


class CommandRecord(Struct, frozen=True):
    """One command from the key to its end. `issued_at` is monotonic, `wall` Unix seconds; `order_id` and
    `order_serial` identify the order in the robot's queue that it placed; `name` is the name that this
    console gave it on the wire, empty if the robot names it. `leg` is the stop that it leads to now, for
    orders whose stops this console sends one by one. `answer`: the robot's answer to this console on the
    end of a goal. `turn` sorts the orders that wait here, None: by `issued_at`. `earlier_goals`: the ids of
    the goals by which it was driven so far, to a stop on the way or until a pause."""

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
    turn: float | None = None
    earlier_goals: tuple[str, ...] = ()

    @property
    def stage(self) -> Stage:
        return self.steps[-1].stage

    @property
    def reason(self) -> Message:
        """Return its detail without the name of its order."""
        reason = self.detail.values.get("reason")
        if isinstance(reason, Message):
            return reason
        return Message(self.detail.removeprefix(f"order {self.order_id}: "))

    @property
    def detail(self) -> Message:
        """Return the text of the current stage."""
        return self.steps[-1].detail

    @property
    def at(self) -> float:
        """The time at which it reached its stage (monotonic)."""
        return self.steps[-1].at

    @property
    def is_decided(self) -> bool:
        """Tell whether its outcome is known. After that, an order continues until its end."""
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
        """The step that decided it, None while it is open. An order that is back in this console's queue is
        open again."""
        waited = max((n for n, step in enumerate(self.steps) if step.stage is Stage.WAITING), default=0)
        return next((step for step in self.steps[waited:] if step.stage not in OPEN), None)

    def has_further_leg(self, kind: Kind) -> bool:
        """Tell whether stops are left that its robot does not have yet."""
        if not kind.gives_stops or not isinstance(self.command, PlaceOrder):
            return False
        return self.leg + 1 < len(self.command.stops)

    def time_of(self, stage: Stage) -> float | None:
        """The time at which it last reached a stage, None if never."""
        return next((step.at for step in reversed(self.steps) if step.stage is stage), None)

    def advanced(self, step: Step) -> "CommandRecord":
        """Return the record one step on, or itself if the table does not allow that step."""
        if step.stage not in NEXT[self.stage]:
            return self
        return replace(self, steps=(*self.steps, step))

    def recognised(self, order: Order, step: Step) -> "CommandRecord":
        """Return the record one step on, with the order that it placed."""
        return replace(self.advanced(step), order_id=order.id, order_serial=order.serial)
