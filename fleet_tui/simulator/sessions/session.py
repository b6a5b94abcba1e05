"""One connected client: reads its operations, keeps its subscriptions, writes the frames that are due.

As on the real bridge the client gets no reply to an invalid operation.
"""

import asyncio
import sys
import uuid
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.frames import Frame, OutgoingFrame
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import BridgeError
from fleet_tui.simulator.sessions.fragments import Assembler, split
from fleet_tui.simulator.sessions.operations import Operation, problem_of
from fleet_tui.simulator.sessions.outbox import COMPRESSIONS, ClientSubscription, Outbox, SubscribeRequest

if TYPE_CHECKING:
    from fleet_tui.simulator.services import ServiceDesk


class Bridge(Protocol):
    """The server as a session sees it."""

    subscribe_delay: float
    dialect: Dialect
    services: "ServiceDesk"
    max_message_size: int | None
    one_by_one: bool
    """True: a client's call or goal must end before its next operation is handled."""

    def note(self, operation: Operation) -> None:
        """Record an operation that arrived."""

    def complain(self, session: "Session", operation: Operation, text: str) -> None:
        """Log an operation that has no effect."""

    def join(self, session: "Session", operation: Operation) -> None:
        """Subscribe a client to a topic, perhaps once more. Raises BridgeError."""

    def welcome(self, session: "Session", topic: str) -> None:
        """A client has subscribed to the topic, perhaps once more."""

    def leave(self, session: "Session", topic: str) -> None:
        """A client has unsubscribed from the topic."""

    def publish_for(self, session: "Session", operation: Operation) -> None:
        """Publish a client's message."""

    def spread(self) -> None:
        """Publish the changes in the fleets."""


@dataclass(eq=False)
class Session:
    """One client's side of the server."""

    connection: ServerConnection
    bridge: Bridge

    def __post_init__(self) -> None:
        self.subscriptions: dict[str, ClientSubscription] = {}
        self.id = uuid.uuid4()
        self.address = self.connection.remote_address[0]
        self._outbox = Outbox()
        self._wake = asyncio.Event()
        self._clock: Callable[[], float] = asyncio.get_running_loop().time
        self._assembler = Assembler()
        self._fragment_size = sys.maxsize  # characters of a text frame that is sent whole

    async def run(self) -> None:
        """Serve until the client is gone."""
        writer = asyncio.create_task(self._write())
        try:
            with suppress(ConnectionClosed):
                async for raw in self.connection:
                    await self._read(raw)
        finally:
            writer.cancel()

    def offer(self, topic: str, publication: OutgoingFrame) -> None:
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
        """Send a frame as it is, after those that are already due."""
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
        if problem := problem_of(operation, self.bridge.dialect.version):
            self.bridge.complain(self, operation, problem)
            return
        try:
            await self._perform(operation)
        except BridgeError as error:
            self.bridge.complain(self, operation, str(error))

    async def _perform(self, operation: Operation) -> None:
        match operation["op"]:
            case "subscribe":
                # One after the other, as on the real bridge: a call behind them waits, too.
                await asyncio.sleep(self.bridge.subscribe_delay)
                self._subscribe(operation)
            case "unsubscribe":
                self._unsubscribe(operation["topic"], operation.get("id"))
            case "call_service":
                call = self.bridge.services.call(self, operation)
                self.bridge.spread()
                if call is not None:
                    await self._wait(call.over)
            case "send_action_goal":
                ended = self.bridge.services.actions.send(self, operation)
                self.bridge.spread()
                await self._wait(ended)
            case "cancel_action_goal":
                self.bridge.services.actions.cancel(self, operation)
                self.bridge.spread()
            case "fragment":
                text = self._assembler.add(operation)
                if text is not None:
                    await self._read(text)
            case _:
                self._share(operation)

    async def _wait(self, over: "asyncio.Future[None]") -> None:
        """Wait for the end of the operation, if the bridge does so."""
        if self.bridge.one_by_one:
            gone = asyncio.ensure_future(self.connection.wait_closed())
            await asyncio.wait((over, gone), return_when=asyncio.FIRST_COMPLETED)
            gone.cancel()

    def _share(self, operation: Operation) -> None:
        """Publish a topic or offer a service of one's own."""
        guests = self.bridge.services.guests
        match operation["op"]:
            case "publish":
                self.bridge.publish_for(self, operation)
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
        subscription = self.subscriptions.setdefault(topic, ClientSubscription())
        asked = operation.get("compression")
        subscription.requests[operation.get("id")] = SubscribeRequest(
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
            subscription.requests.pop(id_, None)
        if id_ is None or not subscription.requests:
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
