"""Service calls in progress."""

import asyncio
from typing import Any

from fleet_tui.simulator.frames import Frame, to_json
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation

GIVEN_UP = "Timeout exceeded while waiting for service response"


def response(operation: Operation, values: Any, result: bool) -> Frame:
    """The frame that answers a call."""
    answer = {"op": "service_response", "service": operation["service"], "values": values, "result": result}
    if operation.get("id") is not None:
        answer["id"] = operation["id"]
    return to_json(answer)


class Call:
    """A client's call: answers are sent until the bridge abandons it after `limit` seconds (None: never)."""

    def __init__(self, client: Client, operation: Operation, limit: float | None) -> None:
        self.operation = operation
        self.given_up = False
        self.over: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        """Done once the answer has been sent, or none will be."""
        self._client = client
        self._timer: asyncio.TimerHandle | None = None
        if limit is not None:
            self._timer = asyncio.get_running_loop().call_later(limit, self._give_up)

    def reply(self, frame: Frame) -> None:
        if self._timer is not None:
            self._timer.cancel()
        if not self.given_up:
            self._client.reply(frame)
            self._end()

    def reply_in(self, seconds: float, frame: Frame) -> None:
        asyncio.get_running_loop().call_later(seconds, self.reply, frame)

    def answer(self, values: Any, result: bool = True) -> None:
        self.reply(response(self.operation, values, result))

    def _give_up(self) -> None:
        self._client.reply(response(self.operation, GIVEN_UP, False))
        self.given_up = True
        self._end()

    def _end(self) -> None:
        if not self.over.done():  # the fault `twice` answers twice
            self.over.set_result(None)
