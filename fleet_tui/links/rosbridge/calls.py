"""Service calls with a deadline: each ends exactly once, whatever the bridge does."""

import asyncio
import itertools
from collections.abc import Mapping
from dataclasses import dataclass

from fleet_tui.links.patience import awake, timed
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros import operations
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message

GRACE = 1.0
"""Seconds after our own deadline at which the bridge drops a call: its word that it did would come before the
end of our waiting, in which only time counts that this process ran, and read as an answer."""


class LinkLostError(LinkError):
    """The link went down during the call: it may or may not have run."""


TIME = "/rosapi/get_time"
OWN_WORD = "/rosapi/fleet_tui_heartbeat"
"""A service that no node offers: the bridge itself reports the error, in 1-2 ms, also without ROS."""


def rosapi_places() -> asyncio.Semaphore:
    """Return the places for questions at one rosapi, of all connections of its bridge together: four at once
    have killed one of ROS 2."""
    return asyncio.Semaphore(2)


class NotAllowedError(LinkError):
    """An allow-list of the bridge lacks the service: the call was dropped, and never runs."""


class NoAnswerError(LinkError):
    """The deadline passed without an answer."""


@dataclass(frozen=True, slots=True)
class PendingCall:
    """A call that was sent, and the future of its answer."""

    id: str
    service: str
    answer: "asyncio.Future[operations.ServiceResponse]"


class Calls:
    """The open calls on one connection. Everything here runs on the network loop."""

    def __init__(self, connection: Connection, places: asyncio.Semaphore) -> None:
        """`places` at the bridge's rosapi: a question waits for one."""
        self._connection = connection
        self._places = places
        self._pending: dict[str, asyncio.Future[operations.ServiceResponse]] = {}
        self._questions: dict[str, asyncio.TimerHandle] = {}
        """Those that rosapi works on, also without anybody who waits, until the bridge drops them."""
        self._ids = itertools.count(1)

    def start(self, service: str, args: Mapping[str, object], within: float) -> "PendingCall":
        """Send a call that the bridge drops once nobody waits `within` seconds for it any more, if it can.

        Raises LinkError if there is no connection.
        """
        return self._start(service, args, float(within + GRACE))

    def _start(self, service: str, args: Mapping[str, object], limit: float | str) -> "PendingCall":
        call_id = f"call:{next(self._ids)}"
        self._connection.send(operations.call_service(call_id, service, args, limit))
        answer = asyncio.get_running_loop().create_future()
        self._pending[call_id] = answer
        return PendingCall(call_id, service, answer)

    async def wait(self, call: "PendingCall", within: float) -> operations.ServiceResponse:
        """Wait at most `within` seconds of running for an answer; may be called again until `forget`.

        Raises LinkLostError or NoAnswerError.
        """
        patience = asyncio.ensure_future(awake(within))
        try:
            await asyncio.wait((call.answer, patience), return_when=asyncio.FIRST_COMPLETED)
        finally:
            patience.cancel()
        if not call.answer.done():
            raise NoAnswerError(
                Message(
                    "from {service} in {within} s: may still be carried out",
                    service=call.service,
                    within=f"{within:g}",
                )
            )
        return call.answer.result()

    async def answers_all(self, within: float) -> bool:
        """Tell whether the bridge answers each call that it allows, at its limit if no node does, and a node
        answers now. Raises LinkLostError."""
        try:
            response = await self.call(TIME, {}, within)
            # A bridge that knows limits declines one that is no number, and calls nothing.
            probe = self._start(TIME, {}, "none") if response.result else None
            if probe is None:
                return False
            try:
                return not (await self.wait(probe, within)).result
            finally:
                self.forget(probe)
        except NoAnswerError:
            return False

    def forget(self, call: "PendingCall") -> None:
        """Stop waiting for this answer."""
        del self._pending[call.id]

    async def call(
        self, service: str, args: Mapping[str, object], within: float
    ) -> operations.ServiceResponse:
        """Send a call and wait for its answer. Raises the errors of `start` and `wait`."""
        _, response = await self.timed(service, args, within)
        return response

    async def timed(
        self, service: str, args: Mapping[str, object], within: float, kept: float = 0.0
    ) -> tuple[float, operations.ServiceResponse]:
        """Send a call and wait for its answer; return the seconds of running between them, too. The bridge
        keeps the call for `kept` seconds if these are more. Raises the errors of `start` and `wait`."""
        is_question = service.startswith("/rosapi/") and service != OWN_WORD
        if is_question:
            await self._take_place(service, within)
        try:
            call = self.start(service, args, max(within, kept))
        except LinkError:
            if is_question:
                self._places.release()
            raise
        if is_question:
            until_dropped = max(within, kept) + GRACE
            loop = asyncio.get_running_loop()
            self._questions[call.id] = loop.call_later(until_dropped, self._leave_place, call.id)
        try:
            return await timed(self.wait(call, within))
        finally:
            self.forget(call)

    async def _take_place(self, service: str, within: float) -> None:
        """Wait for a place at rosapi. Raises NoAnswerError if none gets free in time."""
        try:
            async with asyncio.timeout(within):
                await self._places.acquire()
        except TimeoutError:
            raise NoAnswerError(
                Message(
                    "from {service}: rosapi left others unanswered for {within} s",
                    service=service,
                    within=f"{within:g}",
                )
            ) from None

    def _leave_place(self, call_id: str) -> None:
        """Give the place of a question back: it is answered, was dropped, or lost."""
        if (dropped := self._questions.pop(call_id, None)) is not None:
            dropped.cancel()
            self._places.release()

    def on_response(self, response: operations.ServiceResponse) -> bool:
        """Take an answer; False if no caller waits for it (any more)."""
        self._leave_place(response.id)
        answer = self._pending.get(response.id)
        if answer is None or answer.done():
            return False
        answer.set_result(response)
        return True

    def on_lost(self) -> None:
        """End every open call: a new connection can't deliver their answers."""
        for call_id in [*self._questions]:
            self._leave_place(call_id)
        for answer in self._pending.values():
            if not answer.done():
                answer.set_exception(
                    LinkLostError(Message("link lost before the reply: may still be carried out"))
                )
                answer.exception()  # whoever waited may have been stopped by the same loss
