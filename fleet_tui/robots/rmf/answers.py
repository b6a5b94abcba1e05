"""Answers to requests, and the dispatcher's own list of tasks, as events."""

from collections.abc import Iterable, Mapping
from typing import Any

import msgspec

from fleet_tui.model import events
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleets.events import DispatchFailed, RequestAnswered
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.rmf.encoded import decoder, line_of
from fleet_tui.robots.rmf.fleets import Read
from fleet_tui.robots.rmf.requests import PREFIX
from fleet_tui.robots.ros import messages as ros
from fleet_tui.text.language import Message, joined
from fleet_tui.text.limits import LONGEST_NAME, MOST_ORDERS, truncate

RESPONDING = 2
"""The type of a response that is the answer; another one only asks for patience."""
FAILED_TO_ASSIGN = 4
CANCELLED_IN_FLIGHT = 5
REASONS = {
    FAILED_TO_ASSIGN: Message("no fleet took the task"),
    CANCELLED_IN_FLIGHT: Message("cancelled before a robot had it"),
}


class ResponseMessage(msgspec.Struct, frozen=True):
    """rmf_task_msgs/ApiResponse."""

    type: int
    json_msg: str
    request_id: str


class BookedTask(msgspec.Struct, frozen=True):
    """The booking of the task that an answer is about."""

    id: str = ""


class AnsweredTask(msgspec.Struct, frozen=True):
    """The state of a task in an answer."""

    booking: BookedTask = BookedTask()


class ResponseText(msgspec.Struct, frozen=True):
    """The answer to any request."""

    success: bool
    errors: list[Any] = []
    state: AnsweredTask = AnsweredTask()


class DispatchesMessage(msgspec.Struct, frozen=True):
    """rmf_task_msgs/DispatchStates, its tasks unread."""

    active: list[Any] = []
    finished: list[Any] = []


class DispatchMessage(msgspec.Struct, frozen=True):
    """rmf_task_msgs/DispatchState."""

    task_id: str
    status: int
    errors: list[Any] = []


def read_responses() -> Read:
    """Read a rmf_task_msgs/ApiResponse, those to requests of other programs left out."""
    read, decode = ros.reader(ResponseMessage), decoder(ResponseText)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        response = read(msg)
        if response.type != RESPONDING or not response.request_id.startswith(PREFIX):
            return
        answer = decode(response.json_msg)
        stage = Stage.ACCEPTED if answer.success else Stage.REFUSED
        task = truncate(answer.state.booking.id, LONGEST_NAME) if answer.success else ""
        reason = (
            "" if answer.success else "; ".join(map(_error, answer.errors[:3])) or Message("no reason given")
        )
        yield RequestAnswered(response.request_id.partition(".")[0], at, stage, truncate(reason), task)

    return facts


def _error(value: Any) -> str:
    """Return an error as `category: detail`."""
    if isinstance(value, str):
        try:
            value = msgspec.json.decode(value)
        except msgspec.DecodeError:
            return line_of(value)
    if not isinstance(value, Mapping):
        return line_of(value)
    return ": ".join(filter(None, (line_of(value.get("category")), line_of(value.get("detail")))))


def read_dispatches() -> Read:
    """Read a rmf_task_msgs/DispatchStates: the tasks for which no robot was found."""
    read, read_one = ros.reader(DispatchesMessage), ros.reader(DispatchMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        for one in read_all(
            read_one, [*message.active, *message.finished], Message("tasks"), MOST_ORDERS, []
        ):
            if why := REASONS.get(one.status):
                errors = "; ".join(filter(None, map(_error, one.errors[:3])))
                reason = joined(": ", filter(None, (why, errors)))
                yield DispatchFailed(one.task_id, at, reason, one.status == CANCELLED_IN_FLIGHT)

    return facts
