"""One connected client: reads its operations, keeps its subscriptions, writes what is due to it.

As on the real bridge the client is told nothing about an operation that makes no sense.
"""

import asyncio
import sys
import uuid
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.fragments import Assembler, split
from fleet_tui.simulator.frames import Frame, Payload, Publication
from fleet_tui.simulator.outbox import COMPRESSIONS, Outbox, Subscription, Wish
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import BridgeError

if TYPE_CHECKING:
    from fleet_tui.simulator.guests import Guests

Operation = dict[str, Any]

# Field -> type and whether it must be there; what is said with another type is not listened to.
_FIELDS: Mapping[str, Mapping[str, tuple[type, bool]]] = {
    "subscribe": {
        "topic": (str, True),
        "id": (str, False),
        "type": (str, False),
        "throttle_rate": (int, False),
        "queue_length": (int, False),
        "fragment_size": (int, False),
        "compression": (str, False),
    },
    "unsubscribe": {"topic": (str, True), "id": (str, False)},
    "call_service": {"service": (str, True)},
    "advertise": {"topic": (str, True), "type": (str, True)},
    "unadvertise": {"topic": (str, True)},
    "publish": {"topic": (str, True), "type": (str, False), "msg": (dict, True)},
    "advertise_service": {"service": (str, True), "type": (str, True)},
    "unadvertise_service": {"service": (str, True)},
    "service_response": {"service": (str, True)},
    "fragment": {"data": (str, True), "num": (int, True), "total": (int, True)},
}


class Bridge(Protocol):
    """What a session asks of its server."""

    subscribe_delay: float
    dialect: Dialect
    guests: "Guests"
    max_message_size: int | None

    def note(self, operation: Operation) -> None:
        """Take note of an operation that arrived."""

    def complain(self, session: "Session", operation: Operation, text: str) -> None:
        """Log an operation that has no effect."""

    def call(self, session: "Session", operation: Operation) -> None:
        """Answer a service call, or not."""

    def join(self, session: "Session", operation: Operation) -> None:
        """Bring a topic to a client, who may have it already. Raises BridgeError."""

    def welcome(self, session: "Session", topic: str) -> None:
        """A client has subscribed to the topic, perhaps once more."""

    def leave(self, session: "Session", topic: str) -> None:
        """A client has unsubscribed from the topic."""

    def publish(self, name: str, payload: Payload | None = None) -> None:
        """Publish a message of a topic."""


@dataclass(eq=False)
class Session:
    """One client's side of the server."""

    connection: ServerConnection
    bridge: Bridge

    def __post_init__(self) -> None:
        self.subscriptions: dict[str, Subscription] = {}
        self.id = uuid.uuid4()
        self.address = self.connection.remote_address[0]
        self._outbox = Outbox()
        self._wake = asyncio.Event()
        self._clock: Callable[[], float] = asyncio.get_running_loop().time
        self._assembler = Assembler()
        self._fragment_size = sys.maxsize  # characters of a text frame that comes in one piece

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
        frame = publication.frame(subscription.compression)
        limit = self.bridge.max_message_size
        if isinstance(frame, bytes) and limit is not None and len(frame) > limit:
            text = f"Message of {len(frame)} bytes is longer than max_message_size {limit}"
            self.bridge.complain(self, {"op": "publish", "topic": topic}, text)
            return
        self._outbox.offer(subscription, frame, self._clock())
        self._wake.set()

    def reply(self, frame: Frame) -> None:
        """Send a frame as it is, after what is due already."""
        self._outbox.reply(frame, self._clock())
        self._wake.set()

    async def _read(self, raw: str | bytes) -> None:
        if isinstance(raw, bytes) and self.bridge.dialect.reads_binary:
            try:
                raw = raw.decode()
            except UnicodeDecodeError:
                await self.connection.close()
                return
        try:
            operation = msgspec.json.decode(raw) if isinstance(raw, str) else None
        except (msgspec.DecodeError, RecursionError):
            return
        if not isinstance(operation, dict):
            return
        self.bridge.note(operation)
        if problem := _problem(operation):
            self.bridge.complain(self, operation, problem)
            return
        try:
            await self._perform(operation)
        except BridgeError as error:
            self.bridge.complain(self, operation, str(error))

    async def _perform(self, operation: Operation) -> None:
        match operation["op"]:
            case "subscribe":
                # One after the other, as the bridge does: a call behind them waits too.
                await asyncio.sleep(self.bridge.subscribe_delay)
                self._subscribe(operation)
            case "unsubscribe":
                self._unsubscribe(operation["topic"], operation.get("id"))
            case "call_service":
                self.bridge.call(self, operation)
            case "fragment":
                text = self._assembler.add(operation)
                if text is not None:
                    await self._read(text)
            case _:
                self._share(operation)

    def _share(self, operation: Operation) -> None:
        """Publish a topic or offer a service of one's own."""
        guests = self.bridge.guests
        match operation["op"]:
            case "publish":
                self.bridge.publish(*guests.published(self, operation))
            case "advertise":
                guests.advertise(self, operation["topic"], operation["type"], bool(operation.get("latch")))
            case "unadvertise":
                guests.unadvertise(self, operation["topic"])
            case "advertise_service":
                guests.offer(self, operation["service"], operation["type"])
            case "unadvertise_service":
                guests.withdraw(self, operation["service"])
            case "service_response":
                guests.answered(operation)

    def _subscribe(self, operation: Operation) -> None:
        topic = operation["topic"]
        self.bridge.join(self, operation)
        subscription = self.subscriptions.setdefault(topic, Subscription())
        asked = operation.get("compression")
        subscription.wishes[operation.get("id")] = Wish(
            (operation.get("throttle_rate") or 0) / 1000.0,
            operation.get("queue_length") or 0,
            next((one for one in COMPRESSIONS if one == asked), "none"),
        )
        subscription.settle()
        if size := operation.get("fragment_size"):
            self._fragment_size = min(self._fragment_size, size)
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
                    for part in self._parts(frame):
                        await self.connection.send(part)
                    continue
                self._wake.clear()
                due = self._outbox.next_due
                timer = None if due is None else loop.call_at(due, self._wake.set)
                await self._wake.wait()
                if timer is not None:
                    timer.cancel()

    def _parts(self, frame: Frame) -> Iterable[Frame]:
        if isinstance(frame, bytes):
            return [frame]
        size = min(self._fragment_size, self.bridge.max_message_size or sys.maxsize)
        return split(frame, size, self.bridge.dialect.fragment_id)


def _problem(operation: Operation) -> str:
    """The reason why an operation can't be meant, empty where it can."""
    op = operation.get("op")
    fields = _FIELDS.get(str(op))
    if op is None:
        return "Received a message without an op"
    if fields is None:
        return f"Unknown operation: {op}"
    for name, (type_, needed) in fields.items():
        if operation.get(name) is None:
            if needed:
                return f"Expected a {name} field but none was found"
        elif not isinstance(operation[name], type_):
            return f"Expected field {name} to be one of {type_.__name__}. Invalid value: {operation[name]}"
    return ""
