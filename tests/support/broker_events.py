"""A listener of a connection to a broker that tests can wait on."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.links.transports.mqtt.connection import BrokerConnection
from tests.support.polling import until


class BrokerEvents:
    """Keeps every event of a connection; `connection` is used on the network loop by `call`."""

    def __init__(self, link: Link) -> None:
        self.opened = self.attempts = 0
        self.lost: list[tuple[str, float]] = []
        self.messages: list[tuple[str, bytes, bool]] = []
        self.granted: dict[str, bool] = {}
        self.answers: list[float] = []
        self.sent: list[tuple[str, bytes]] = []
        self.too_large: list[tuple[str, int]] = []
        self.connection = BrokerConnection(link, self)

    def on_connecting(self) -> None:
        self.attempts += 1

    def on_open(self) -> None:
        self.opened += 1

    def on_lost(self, reason: str, next_try_in: float) -> None:
        self.lost.append((reason, next_try_in))

    def on_message(self, topic: str, payload: bytes, retained: bool) -> None:
        self.messages.append((topic, payload, retained))

    def on_subscribed(self, pattern: str, granted: bool) -> None:
        self.granted[pattern] = granted

    def on_answer(self, seconds: float) -> None:
        self.answers.append(seconds)

    def on_sent(self, topic: str, payload: bytes) -> None:
        self.sent.append((topic, payload))

    def on_too_large(self, topic: str, size: int) -> None:
        self.too_large.append((topic, size))

    async def call(self, do: Callable[[], object]) -> None:
        """Call on the network loop, and raise here what that raises."""

        async def called() -> None:
            do()

        await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(called(), network_loop()))

    async def subscribe(self, *patterns: str) -> None:
        await self.call(lambda: self.connection.subscribe(patterns))
        await until(lambda: set(patterns) <= set(self.granted))


@asynccontextmanager
async def connecting(link: Link, wait: bool = True) -> AsyncIterator[BrokerEvents]:
    events = BrokerEvents(link)
    await events.call(events.connection.connect)
    try:
        if wait:
            await until(lambda: events.opened)
        yield events
    finally:
        await events.call(events.connection.shut)
