"""Service calls with a deadline: each ends exactly once, whatever the bridge does."""

import asyncio
import itertools
from collections.abc import Mapping

from fleet_tui.errors import LinkError
from fleet_tui.link.transport import Connection
from fleet_tui.rosbridge import operations


class LinkLostError(LinkError):
    """The link went down with the call under way: whether it ran is unknown."""


class NoAnswerError(LinkError):
    """The deadline passed without an answer."""


class Calls:
    """The calls under way on one connection. Everything here runs on the network loop."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._pending: dict[str, asyncio.Future[operations.ServiceResponse]] = {}
        self._ids = itertools.count(1)

    async def call(
        self, service: str, args: Mapping[str, object], within: float
    ) -> operations.ServiceResponse:
        """Call a service and wait `within` seconds at most.

        Raises LinkError if nothing was sent, LinkLostError or NoAnswerError if it was.
        """
        call_id = f"call:{next(self._ids)}"
        self._connection.send(operations.call_service(call_id, service, args))
        answer = asyncio.get_running_loop().create_future()
        self._pending[call_id] = answer
        try:
            return await asyncio.wait_for(answer, within)
        except TimeoutError:
            raise NoAnswerError(f"no answer from {service} in {within:g} s") from None
        finally:
            del self._pending[call_id]

    def on_response(self, response: operations.ServiceResponse) -> bool:
        """Take an answer; False if nobody waits for it (any more)."""
        answer = self._pending.get(response.id)
        if answer is None or answer.done():
            return False
        answer.set_result(response)
        return True

    def on_lost(self) -> None:
        """End every call under way: on a new connection no answer to them can come."""
        for answer in self._pending.values():
            if not answer.done():
                answer.set_exception(LinkLostError("the link went down before an answer came"))
