"""Answers to the calls of commands: each command ends exactly once, whatever the answers and their timing."""

import logging
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress

from fleet_tui.links.rosbridge.calls import (
    GRACE,
    Calls,
    LinkLostError,
    NoAnswerError,
    NotAllowedError,
    PendingCall,
)
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.links.tap import Tap
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import CallNotAllowed
from fleet_tui.model.link import SERVICES_GLOB
from fleet_tui.robots.adapter import Adapter, ServiceCall
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message, message_of

LOG = logging.getLogger(__name__)

# An answer later than its deadline by no more than this many seconds still counts.
LATE_ANSWER = 60.0
OVERDUE = GRACE + 1.0
"""Seconds after the deadline by which a bridge that gives calls up has said so."""
PROBE = 1.0
"""Seconds for rosapi to answer whether it does."""
WORST = (Stage.NOT_SENT, Stage.ACCEPTED, Stage.REFUSED, Stage.UNKNOWN)
"""Possible ends of the calls of one command, worst last: one of which a part was sent counts as sent."""


def decoded(tap: Tap | None, link: str, payload: bytes, is_binary: bool) -> operations.Operation | None:
    """Record and decode a frame of a command connection; None if it contains nothing for the console."""
    if tap is not None:
        tap.on_received(link, "commands", payload, is_binary, time.monotonic())
    try:
        return None if is_binary else operations.decode(payload)
    except WireError as problem:
        LOG.warning("%s", problem)
        return None


class Answers:
    """Waits for the answers to commands on one connection. `advance` receives the number of a command, the
    stage it reached and the reason. Runs on the network loop."""

    def __init__(
        self,
        link: str,
        calls: Calls,
        services: Services,
        adapters: Mapping[str, Adapter],
        writer: Writer,
        timeout: float,
        advance: Callable[[int, Stage, Message], None],
    ) -> None:
        """`timeout` of an answer in seconds; `adapters` by robot."""
        self._link = link
        self._calls = calls
        self._services = services
        self._adapters = adapters
        self._writer = writer
        self._timeout = timeout
        self._advance = advance

    async def wait(
        self,
        command_id: int,
        command: Command,
        calls: Sequence[tuple[ServiceCall, PendingCall]],
        sent_at: float,
    ) -> None:
        """Wait for all answers to a command; its result is the worst of them."""
        if (end := await self.end_of(command_id, command, calls, sent_at)) is not None:
            self._advance(command_id, *end)

    async def end_of(
        self,
        command_id: int,
        command: Command,
        calls: Sequence[tuple[ServiceCall, PendingCall]],
        sent_at: float,
    ) -> tuple[Stage, Message] | None:
        """Return the worst of the answers; None if one never came, which is reported."""
        adapter = self._adapters[command.robot]
        ends = list[tuple[Stage, Message]]()
        try:
            for outgoing, call in calls:
                try:
                    response = await self._answer(command_id, call)
                except NotAllowedError as problem:
                    ends.append((Stage.NOT_SENT, message_of(problem)))
                    continue
                self._learn(command, outgoing, response, sent_at)
                ends.append(adapter.outcome(command, response.values, response.result))
            return max(ends, key=lambda end: WORST.index(end[0]))
        except NoAnswerError:
            return None
        except LinkLostError as problem:
            return Stage.UNKNOWN, message_of(problem)
        except Exception as problem:
            # Whatever fails here, the operator must see that the result of this command is unknown.
            LOG.exception("command %d", command_id)
            return Stage.UNKNOWN, Message("internal error: {problem}", problem=problem)
        finally:
            for _, call in calls:
                self._calls.forget(call)

    def _learn(
        self, command: Command, outgoing: ServiceCall, response: ServiceResponse, sent_at: float
    ) -> None:
        """Extract the other facts in an answer, besides the result of the command."""
        self._services.on_answer(outgoing.address, response.values, response.result)
        robot, adapter = self._writer.store.state.robots[command.robot], self._adapters[command.robot]
        for fact in adapter.learned(outgoing, response.values, robot, sent_at, time.monotonic()):
            self._writer.apply(fact)

    async def _answer(self, command_id: int, call: PendingCall) -> ServiceResponse:
        try:
            return await self._calls.wait(call, self._timeout)
        except NoAnswerError as problem:
            self.check_allowed(call.service)
            self._advance(command_id, Stage.NO_ANSWER, message_of(problem))
        with suppress(NoAnswerError):
            return await self._calls.wait(call, OVERDUE)
        if await self._calls.answers_all(PROBE) and not call.answer.done():
            self._writer.apply(CallNotAllowed(self._link, call.service, SERVICES_GLOB))
            self.check_allowed(call.service)
        return await self._calls.wait(call, LATE_ANSWER)

    def check_allowed(self, name: str) -> None:
        """Raise NotAllowedError if the bridge is known to drop calls of a service, or goals of an action."""
        if problem := self._writer.store.state.links[self._link].refusal_of(name):
            raise NotAllowedError(problem)
