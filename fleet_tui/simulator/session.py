"""One connected client: reads its operations, keeps its subscriptions, writes what is due to it.

As on the real bridge nothing is said about an operation that makes no sense.
"""

import asyncio
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Protocol

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.frames import Frame, Publication
from fleet_tui.simulator.outbox import Outbox, Subscription, Wish

Operation = dict[str, Any]

# Field -> type and whether it must be there; what is said with another type is not listened to.
_FIELDS: Mapping[str, Mapping[str, tuple[type, bool]]] = {
    "subscribe": {
        "topic": (str, True),
        "id": (str, False),
        "type": (str, False),
        "throttle_rate": (int, False),
        "queue_length": (int, False),
        "compression": (str, False),
    },
    "unsubscribe": {"topic": (str, True), "id": (str, False)},
    "call_service": {"service": (str, True)},
}


class Bridge(Protocol):
    """What a session asks of its server."""

    subscribe_delay: float

    def note(self, operation: Operation) -> None:
        """Take note of an operation that arrived."""

    def call(self, session: "Session", operation: Operation) -> None:
        """Answer a service call, or not."""

    def admit(self, topic: str, type_: str | None) -> bool:
        """Whether the topic may be subscribed to with this type."""

    def welcome(self, session: "Session", topic: str) -> None:
        """A client has subscribed to the topic, perhaps once more."""

    def leave(self, session: "Session", topic: str) -> None:
        """A client has unsubscribed from the topic."""


@dataclass(eq=False)
class Session:
    """One client's side of the server."""

    connection: ServerConnection
    bridge: Bridge

    def __post_init__(self) -> None:
        self.subscriptions: dict[str, Subscription] = {}
        self._outbox = Outbox()
        self._wake = asyncio.Event()
        self._clock: Callable[[], float] = asyncio.get_running_loop().time

    async def run(self) -> None:
        """Serve until the client is gone."""
        writer = asyncio.create_task(self._write())
        try:
            with suppress(ConnectionClosed):
                async for raw in self.connection:
                    await self._read(raw)
        finally:
            writer.cancel()

    def offer(self, topic: str, publication: Publication) -> None:
        """Send a publication as this client subscribed to it: throttled, the newest kept."""
        subscription = self.subscriptions[topic]
        self._outbox.offer(subscription, publication.frame(subscription.compression), self._clock())
        self._wake.set()

    def reply(self, frame: Frame) -> None:
        """Send a frame as it is, after what is due already."""
        self._outbox.reply(frame, self._clock())
        self._wake.set()

    def reply_in(self, seconds: float, frame: Frame) -> None:
        """The same, after so many seconds."""
        asyncio.get_running_loop().call_later(seconds, self.reply, frame)

    async def _read(self, raw: str | bytes) -> None:
        try:
            operation = msgspec.json.decode(raw) if isinstance(raw, str) else None
        except (msgspec.DecodeError, RecursionError):
            return
        if not isinstance(operation, dict):
            return
        self.bridge.note(operation)
        if not _makes_sense(operation):
            return
        match operation["op"]:
            case "subscribe":
                # One after the other, as the bridge does: a call behind them waits too.
                await asyncio.sleep(self.bridge.subscribe_delay)
                self._subscribe(operation)
            case "unsubscribe":
                self._unsubscribe(operation["topic"], operation.get("id"))
            case "call_service":
                self.bridge.call(self, operation)

    def _subscribe(self, operation: Operation) -> None:
        topic = operation["topic"]
        if not self.bridge.admit(topic, operation.get("type")):
            return
        subscription = self.subscriptions.setdefault(topic, Subscription())
        compression = operation.get("compression", "none")
        subscription.wishes[operation.get("id")] = Wish(
            (operation.get("throttle_rate") or 0) / 1000.0,
            operation.get("queue_length") or 0,
            compression if compression in ("png", "cbor") else "none",
        )
        subscription.settle()
        self.bridge.welcome(self, topic)

    def _unsubscribe(self, topic: str, id_: str | None) -> None:
        subscription = self.subscriptions.get(topic)
        if subscription is None:
            return
        if id_ is not None:
            subscription.wishes.pop(id_, None)
        if id_ is None or not subscription.wishes:
            subscription.waiting.clear()
            del self.subscriptions[topic]
            self.bridge.leave(self, topic)
        else:
            subscription.settle()

    async def _write(self) -> None:
        loop = asyncio.get_running_loop()
        with suppress(ConnectionClosed):
            while True:
                frame = self._outbox.take(loop.time())
                if frame is not None:
                    await self.connection.send(frame)
                    continue
                self._wake.clear()
                due = self._outbox.next_due
                timer = None if due is None else loop.call_at(due, self._wake.set)
                await self._wake.wait()
                if timer is not None:
                    timer.cancel()


def _makes_sense(operation: Operation) -> bool:
    fields = _FIELDS.get(str(operation.get("op")))
    if fields is None:
        return False
    return all(
        isinstance(operation[name], type_) if operation.get(name) is not None else not needed
        for name, (type_, needed) in fields.items()
    )
