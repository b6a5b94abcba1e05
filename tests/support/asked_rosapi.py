"""A bridge as the queries of rosapi see it: answers by service and arguments."""

import asyncio
from collections.abc import Callable, Mapping
from typing import Any, cast

from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.rosbridge.calls import rosapi_places
from fleet_tui.simulator.calls import Call
from fleet_tui.simulator.frames import Frame
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message

Answer = Callable[[Mapping[str, Any]], object]


class CountedQuestions:
    """Deliver the answers of a simulated rosapi some seconds late, and count the `most` that are open at
    once."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._open = self.most = 0

    def deliver(self, call: Call, frame: Frame) -> None:
        self._open += 1
        self.most = max(self.most, self._open)
        asyncio.get_running_loop().call_later(self._seconds, self._answer, call, frame)

    def _answer(self, call: Call, frame: Frame) -> None:
        self._open -= 1
        call.reply(frame)


class AskedRosapi:
    """Answers each call in the loop's next turn; `deaf` ones are not answered at all."""

    def __init__(self, **answers: Answer) -> None:
        self.answers, self.deaf = answers, set[str]()
        self.lost = ""
        self.places = rosapi_places()
        self.asked: list[tuple[str, Mapping[str, Any]]] = []
        self.open = self.most_open = 0

    async def call(self, service: str, args: Mapping[str, object], _within: float) -> object:
        name = service.removeprefix("/rosapi/")
        self.asked.append((name, args))
        self.open += 1
        self.most_open = max(self.most_open, self.open)
        await asyncio.sleep(0)
        self.open -= 1
        if name in self.deaf:
            raise LinkError(Message("no answer"))
        return self.answers[name](args) if name in self.answers else f"service {service} does not exist"

    @property
    def wire(self) -> BridgeConnection:
        return cast("BridgeConnection", self)
