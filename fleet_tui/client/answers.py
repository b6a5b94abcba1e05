"""Answers to the calls of commands: each command ends once, whatever they say, and when."""

import logging
import time
from collections.abc import Callable, Mapping, Sequence

from fleet_tui.adapters.adapter import Adapter, ServiceCall
from fleet_tui.adapters.ros import operations
from fleet_tui.adapters.ros.operations import ServiceResponse
from fleet_tui.client.calls import Calls, LinkLostError, NoAnswerError, PendingCall
from fleet_tui.client.services import Services
from fleet_tui.client.tap import Tap
from fleet_tui.client.writer import Writer
from fleet_tui.errors import WireError
from fleet_tui.model.commands import Command, Stage

LOG = logging.getLogger(__name__)

# An answer that comes after its deadline, but within this many seconds, is still the robot's word.
LATE_ANSWER = 60.0
WORST = (Stage.ACCEPTED, Stage.REFUSED, Stage.UNKNOWN)
"""Ends of the calls of one command, the worst last."""


def decoded(tap: Tap | None, link: str, payload: bytes, is_binary: bool) -> operations.Operation | None:
    """Record a frame of a command connection and decode it; None where it says nothing to us."""
    if tap is not None:
        tap.heard(link, "commands", payload, is_binary, time.monotonic())
    try:
        return None if is_binary else operations.decode(payload)
    except WireError as problem:
        LOG.warning("%s", problem)
        return None


class Answers:
    """Waits for the answers of commands on one connection. `advance` takes the stage that a command reached,
    by its number, with the reason. Runs on the network loop."""

    def __init__(
        self,
        calls: Calls,
        services: Services,
        adapters: Mapping[str, Adapter],
        writer: Writer,
        timeout: float,
        advance: Callable[[int, Stage, str], None],
    ) -> None:
        """`timeout` of an answer in seconds; `adapters` by robot."""
        self._calls, self._services, self._adapters = calls, services, adapters
        self._writer, self._timeout, self._advance = writer, timeout, advance

    async def wait(
        self,
        command_id: int,
        command: Command,
        calls: Sequence[tuple[ServiceCall, PendingCall]],
        sent_at: float,
    ) -> None:
        """Wait for all answers of a command: it went as well as the worst of them."""
        adapter = self._adapters[command.robot]
        ends = list[tuple[Stage, str]]()
        try:
            for outgoing, call in calls:
                response = await self._answer(command_id, call)
                self._learn(command, outgoing, response, sent_at)
                ends.append(adapter.outcome(command, response.values, response.result))
            stage, words = max(ends, key=lambda end: WORST.index(end[0]))
        except NoAnswerError:
            return
        except LinkLostError as problem:
            stage, words = Stage.UNKNOWN, str(problem)
        except Exception as problem:
            # Whatever is wrong with us, the operator must learn that nothing is known of this command.
            LOG.exception("command %d", command_id)
            stage, words = Stage.UNKNOWN, f"internal error: {problem}"
        finally:
            for _, call in calls:
                self._calls.forget(call)
        self._advance(command_id, stage, words)

    def _learn(
        self, command: Command, outgoing: ServiceCall, response: ServiceResponse, sent_at: float
    ) -> None:
        """Take from an answer what it tells beside how the command went."""
        self._services.answered(outgoing.address, response.values, response.result)
        robot, adapter = self._writer.store.state.robots[command.robot], self._adapters[command.robot]
        for fact in adapter.learned(outgoing, response.values, robot, sent_at, time.monotonic()):
            self._writer.take(fact)

    async def _answer(self, command_id: int, call: PendingCall) -> ServiceResponse:
        try:
            return await self._calls.wait(call, self._timeout)
        except NoAnswerError as problem:
            self._advance(command_id, Stage.NO_ANSWER, str(problem))
        return await self._calls.wait(call, LATE_ANSWER)
