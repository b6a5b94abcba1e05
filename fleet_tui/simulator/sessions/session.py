"""One connected client: reads its operations, keeps its subscriptions, writes the frames that are due.

As on the real bridge the client gets no reply to an invalid operation.
"""

import asyncio
import json
import sys
from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any

import msgspec
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.frames import Frame, to_json
from fleet_tui.simulator.ros.errors import BridgeError
from fleet_tui.simulator.sessions.client import COMPRESSIONS, Client, ClientSubscription, SubscribeRequest
from fleet_tui.simulator.sessions.operations import Operation, problem_of
from fleet_tui.simulator.topics import TopicDesk

UNFINISHED = 100  # messages of one client that may be incomplete at a time

_RESPONSE = '{"op":"service_response"'


class Session:
    def __init__(self, connection: ServerConnection, bridge: TopicDesk) -> None:
        self.connection = connection
        self.client = Client(connection.remote_address[0])
        self._bridge = bridge
        self._assembler = Assembler()

    async def run(self) -> None:
        """Serve until the client is gone."""
        writer = asyncio.create_task(self._write())
        try:
            with suppress(ConnectionClosed):
                async for raw in self.connection:
                    await self._read(raw)
        finally:
            writer.cancel()

    async def _read(self, raw: str | bytes) -> None:
        if isinstance(raw, bytes) and self._bridge.dialect.reads_binary:
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
        self._bridge.received.append(operation)
        if problem := problem_of(operation, self._bridge.dialect.version):
            self._bridge.complain(self.client, operation, problem)
            return
        if isinstance(size := operation.get("fragment_size"), int) and size > 0:
            self.client.fragment_size = size  # of whatever operation, from now on for all that is sent
        try:
            if not self._is_refused(operation):
                await self._perform(operation)
        except BridgeError as error:
            self._bridge.complain(self.client, operation, str(error))

    def _is_refused(self, operation: Operation) -> bool:
        what = {"subscribe": "topic", "call_service": "service", "send_action_goal": "action"}.get(
            operation["op"]
        )
        return what is not None and self._bridge.refuses(self.client, what, operation[what])

    async def _perform(self, operation: Operation) -> None:
        match operation["op"]:
            case "subscribe":
                # One after the other, as on the real bridge: a call behind them waits, too.
                await asyncio.sleep(self._bridge.subscribe_delay)
                self._subscribe(operation)
            case "unsubscribe":
                self._unsubscribe(operation["topic"], operation.get("id"))
            case "call_service":
                call = self._bridge.services.call(self.client, operation)
                self._bridge.spread()
                if call is not None:
                    await self._wait(call.over)
            case "send_action_goal":
                ended = self._bridge.services.actions.send(self.client, operation)
                self._bridge.spread()
                await self._wait(ended)
            case "cancel_action_goal":
                self._bridge.services.actions.cancel(self.client, operation)
                self._bridge.spread()
            case "fragment":
                text = self._assembler.add(operation)
                if text is not None:
                    await self._read(text)
            case _:
                self._share(operation)

    async def _wait(self, over: asyncio.Future[None]) -> None:
        """Wait for the end of the operation, if the bridge does so."""
        if self._bridge.one_by_one:
            gone = asyncio.ensure_future(self.connection.wait_closed())
            await asyncio.wait((over, gone), return_when=asyncio.FIRST_COMPLETED)
            gone.cancel()

    def _share(self, operation: Operation) -> None:
        """Publish a topic or offer a service of one's own."""
        guests = self._bridge.services.guests
        match operation["op"]:
            case "publish":
                self._bridge.publish_for(self.client, operation)
            case "advertise":
                guests.advertise(
                    self.client, operation["topic"], operation["type"], bool(operation.get("latch"))
                )
            case "unadvertise":
                guests.unadvertise(self.client, operation["topic"])
            case "advertise_service":
                guests.offer(self.client, operation["service"], operation["type"])
            case "unadvertise_service":
                guests.withdraw(self.client, operation["service"])
            case "service_response":
                guests.answered(operation)

    def _subscribe(self, operation: Operation) -> None:
        topic = operation["topic"]
        self._bridge.join(self.client, operation)
        subscription = self.client.subscriptions.setdefault(topic, ClientSubscription())
        asked = operation.get("compression")
        subscription.requests[operation.get("id")] = SubscribeRequest(
            (operation.get("throttle_rate") or 0) / 1000.0,
            operation.get("queue_length") or 0,
            next((one for one in COMPRESSIONS if one == asked), "none"),
        )
        subscription.settle()
        self._bridge.welcome(self.client, topic)

    def _unsubscribe(self, topic: str, id_: str | None) -> None:
        subscription = self.client.subscriptions.get(topic)
        if subscription is None:
            return
        if id_ is not None:
            subscription.requests.pop(id_, None)
        if id_ is None or not subscription.requests:
            subscription.waiting.clear()
            del self.client.subscriptions[topic]
            self._bridge.leave(self.client, topic)
        else:
            subscription.settle()

    async def _write(self) -> None:
        with suppress(ConnectionClosed):
            while True:
                for part in self._parts(await self.client.next_frame()):
                    await self.connection.send(part)

    def _parts(self, frame: Frame) -> Iterable[Frame]:
        if isinstance(frame, bytes):
            return [frame]
        size = min(self.client.fragment_size, self._bridge.max_message_size or sys.maxsize)
        return split(frame, size, self._bridge.dialect.fragment_id)


def split(text: str, size: int, default_id: int | str) -> Iterator[str]:
    """Split a text into frames of at most `size` characters each; a shorter one is returned whole. A fragment
    has the id of the message, if it has one."""
    if len(text) <= size:
        yield text
        return
    own = json.loads(text).get("id") if text.startswith(_RESPONSE) else None
    id_ = default_id if own is None else own
    total = -(-len(text) // size)
    for number in range(total):
        data = text[number * size : (number + 1) * size]
        yield to_json({"op": "fragment", "id": id_, "data": data, "num": number, "total": total})


class Assembler:
    def __init__(self) -> None:
        self._parts: dict[object, dict[int, str]] = {}

    def add(self, fragment: dict[str, Any]) -> str | None:
        """Take a fragment; the whole text with the last one."""
        id_, number, total = fragment["id"], fragment["num"], fragment["total"]
        if not 0 <= number < total:
            return None
        parts = self._parts.setdefault(id_, {})
        parts[number] = fragment["data"]
        if len(parts) < total:
            if len(self._parts) > UNFINISHED:
                del self._parts[next(iter(self._parts))]
            return None
        del self._parts[id_]
        return "".join(parts[i] for i in sorted(parts))
