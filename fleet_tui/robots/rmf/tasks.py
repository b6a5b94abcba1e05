"""States of tasks as events: one message has one task."""

import re
from collections.abc import Iterable
from typing import Any

import msgspec

from fleet_tui.model import events
from fleet_tui.model.fleets.events import TaskReported
from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import PENDING, OrderState
from fleet_tui.robots.rmf.encoded import line_of, text_reader
from fleet_tui.robots.rmf.fleets import Read
from fleet_tui.robots.rmf.names import robot_name
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import LONGEST_NAME, truncate

TASK = "task"
"""The action of tasks among goals."""
STATES = {
    **dict.fromkeys(("uninitialized", "queued", "standby"), OrderState.QUEUED),
    **dict.fromkeys(("underway", "delayed", "blocked", "error"), OrderState.IN_PROCESS),
    **dict.fromkeys(("skipped", "canceled", "killed"), OrderState.CANCELLED),
    "failed": OrderState.FAILED,
    "completed": OrderState.DONE,
}
"""States of a task. One that is blocked or in error may still go on."""
PLACE = re.compile(r"\[place:([^\]]*)\]")
"""A place in the words of a phase."""
EMERGENCY = "emergency pullover"
"""The label of an interruption that only the end of an emergency ends."""
LONGEST_TASK = 1e7
"""Seconds above which an estimate is invalid."""


class BookingMessage(msgspec.Struct, frozen=True):
    """The booking of a task."""

    id: str
    requester: str = ""


class AssignmentMessage(msgspec.Struct, frozen=True):
    """The fleet and the robot of a task."""

    group: str
    name: str


class PhaseMessage(msgspec.Struct, frozen=True):
    """A phase of a task."""

    category: str = ""
    detail: Any = None


class InterruptionMessage(msgspec.Struct, frozen=True):
    """An interruption of a task: open without `resumed_by`."""

    labels: list[Any] = []
    resumed_by: Any = None


class TaskMessage(msgspec.Struct, frozen=True):
    """The state of a task."""

    booking: BookingMessage
    category: str = ""
    detail: Any = None
    assigned_to: AssignmentMessage | None = None
    status: str = ""
    estimate_millis: float | None = None
    phases: dict[str, PhaseMessage] = {}
    active: int | None = None
    interruptions: dict[str, InterruptionMessage] = {}
    cancellation: Any = None


class TaskUpdate(msgspec.Struct, frozen=True):
    """task_state_update."""

    data: TaskMessage


def read_tasks() -> Read:
    """Read a task_state_update."""
    read = text_reader(TaskUpdate)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        task = read(msg).data
        if not task.booking.id or len(task.booking.id) > LONGEST_NAME:
            raise WireError(f"booking.id: {truncate(task.booking.id, 40)!r} can't be the id of a task")
        if (assigned := task.assigned_to) is None:
            return
        millis = task.estimate_millis
        seconds = None if millis is None or not 0.0 < millis <= LONGEST_TASK * 1e3 else millis / 1e3
        # Also one of an unknown robot: it may have been another one's before.
        yield TaskReported(robot_name(assigned.group, assigned.name), at, goal_of(task), seconds)

    return facts


def goal_of(task: TaskMessage) -> Goal:
    """Return a task as a goal with a name."""
    state, held = STATES.get(task.status), {}
    if state in PENDING:
        held = {token: one for token, one in task.interruptions.items() if one.resumed_by is None}
    id_ = task.booking.id
    return Goal(
        id_,
        id_,
        TASK,
        OrderState.PAUSED if held else state,
        truncate(task.status, LONGEST_NAME),
        label=_label(task),
        is_ending=task.cancellation is not None,
        requester=truncate(task.booking.requester, LONGEST_NAME),
        tokens=tuple(token for token, one in held.items() if EMERGENCY not in one.labels),
    )


def _label(task: TaskMessage) -> str:
    """Return the words of a task for people: those of its active phase, else its own."""
    phase = task.phases.get(str(task.active)) if task.active is not None else None
    detail = line_of(phase.detail) if phase else ""
    detail = detail or line_of(task.detail)
    category, told = line_of(task.category), PLACE.sub(r"\1", detail)
    return truncate(": ".join(filter(None, (category, told))) or "task", LONGEST_NAME)
