"""One session with a broker, from its connection to its loss: a client of paho on the network loop.

MQTT 3.1.1 with a clean session. Only this package uses paho. By itself it blocks while it connects, keeps
messages for a later connection unless their QoS is 0, and notices a frozen broker after twice the keepalive.
"""

import asyncio
import logging
import ssl
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

import paho.mqtt.client as mqtt
from paho.mqtt.reasoncodes import ReasonCode

from fleet_tui.config.access import secret
from fleet_tui.config.schema import Link
from fleet_tui.links.transports.mqtt import reasons
from fleet_tui.links.transports.mqtt.fed_client import PIECE, FedClient
from fleet_tui.links.transports.mqtt.listener import BrokerListener
from fleet_tui.links.transports.tls import tls_context
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import EMPTY, Message

LOG = logging.getLogger(__name__)

PORTS = {"mqtt": 1883, "mqtts": 8883}
KEEPALIVE = 5
"""Seconds without a message after which the broker is told that we live, and tells others that we don't."""
CONNECT_TIMEOUT = 5.0
BEAT_EVERY = 2.0
BEAT_TIMEOUT = 5.0
"""Seconds between our questions to the broker, and until one without an answer means that it is frozen."""
NOWHERE = "fleet-tui/heartbeat"
"""A topic to unsubscribe from without a subscription: a broker must answer that, whatever the user's rights,
and it changes nothing."""
MOST_LOGGED = 100
FAILED = 128
"""Reason code of a refused subscription."""


GATHER = 0.04
"""Seconds for which messages are gathered after a read: to wake up costs as much as to read."""


class BrokerSession:
    """A connected client. Everything runs on the network loop unless noted otherwise."""

    def __init__(self, link: Link, client_id: str, listener: BrokerListener) -> None:
        self._link = link
        self._listener = listener
        self._limit = int(link.max_message_mb * 1e6)
        self._opened: asyncio.Future[Message] = asyncio.get_running_loop().create_future()
        """The reason that there is no session, empty if there is one."""
        self._ended: asyncio.Future[Message] = asyncio.get_running_loop().create_future()
        self._asked: dict[int, Sequence[str]] = {}
        """Patterns by the ids of unanswered subscriptions."""
        self._beats: dict[int, float] = {}
        """Times at which unanswered signs of life were sent, by their ids."""
        self._logged = set[str]()
        self._beating: asyncio.Task[None] | None = None
        client = self._client = FedClient(client_id, self._take)
        client.connect_timeout = CONNECT_TIMEOUT
        client.on_connect = self._on_connect
        client.on_disconnect = self._on_disconnect
        client.on_message = self._on_message
        client.on_subscribe = self._on_subscribe
        client.on_unsubscribe = self._on_unsubscribe
        self._driver = PahoDriver(self._client, self._is_awaited, self._fail)

    async def open(self) -> None:
        """Connect and log in, with secrets and certificates read again: they may have been renewed.

        Raises LinkError, ConfigError, OSError or ValueError.
        """
        link, client = self._link, self._client
        if user := secret(link, "user"):
            client.username_pw_set(user, secret(link, "password") or None)
        if context := await asyncio.to_thread(tls_context, link):
            client.tls_set_context(context)
        host, port = link.host_and_port
        await asyncio.to_thread(client.connect, host, port or PORTS[link.scheme], KEEPALIVE)
        try:
            reason = await asyncio.wait_for(asyncio.shield(self._opened), CONNECT_TIMEOUT)
        except TimeoutError:
            reason = reasons.NO_ANSWER
        if reason:
            raise LinkError(reason)
        self._beating = asyncio.ensure_future(self._beat())

    async def ended(self) -> Message:
        """Wait for the end of the connection, and return its reason."""
        return await asyncio.shield(self._ended)

    @property
    def silence(self) -> float:
        """Seconds for which the broker owes us an answer, 0 if it owes none."""
        return time.monotonic() - min(self._beats.values()) if self._beats else 0.0

    def subscribe(self, patterns: Sequence[str]) -> None:
        """Subscribe to topics; the answers come one by one. Raises LinkError."""
        code, number = self._client.subscribe([(pattern, 1) for pattern in patterns])
        if code or number is None:
            raise LinkError(Message("no link"))
        self._asked[number] = patterns

    def unsubscribe(self, patterns: Sequence[str]) -> None:
        """Unsubscribe from topics. Raises LinkError."""
        if self._client.unsubscribe(list(patterns))[0]:
            raise LinkError(Message("no link"))

    def publish(self, topic: str, payload: bytes) -> None:
        """Send a message now, once at most: nothing repeats it. Raises LinkError."""
        if self._ended.done() or self._client.publish(topic, payload, qos=0).rc:
            raise LinkError(Message("no link"))
        self._driver.write()
        if self._ended.done():
            raise LinkError(Message("no link"))
        self._listener.on_sent(topic, payload)

    def close(self) -> None:
        """Close the connection: the broker hears of it if it can."""
        if self._beating is not None:
            self._beating.cancel()
        self._driver.close()
        _settle(self._ended, reasons.LOST)

    def _is_awaited(self) -> bool:
        """Tell whether the broker owes us an answer, whose time is measured."""
        return bool(self._beats or self._asked) or not self._opened.done()

    def _fail(self) -> None:
        """End a connection whose server sends what is not MQTT."""
        _settle(self._opened, reasons.NO_ANSWER)
        _settle(self._ended, reasons.LOST)

    async def _beat(self) -> None:
        """Ask the broker for a sign of life, again and again."""
        while not self._ended.done():
            if self.silence > BEAT_TIMEOUT:
                _settle(self._ended, reasons.STOPPED)
                return
            code, number = self._client.unsubscribe(NOWHERE)
            if not code and number is not None:
                self._beats[number] = time.monotonic()
                self._driver.write()
            await asyncio.sleep(BEAT_EVERY)

    def _on_connect(
        self, _client: mqtt.Client, _data: Any, _flags: mqtt.ConnectFlags, code: ReasonCode, _more: Any
    ) -> None:
        _settle(self._opened, reasons.rejected(code.value, self._link) if code.value else EMPTY)

    def _on_disconnect(
        self, _client: mqtt.Client, _data: Any, _flags: mqtt.DisconnectFlags, _code: ReasonCode, _more: Any
    ) -> None:
        _settle(self._opened, reasons.dropped(self._link))
        _settle(self._ended, reasons.LOST)

    def _on_message(self, _client: mqtt.Client, _data: Any, message: mqtt.MQTTMessage) -> None:
        try:
            topic = message.topic
        except UnicodeDecodeError as problem:
            if self._is_new(problem):
                LOG.warning("message with an unreadable topic: %s", problem)
            return
        self._take(topic, bytes(message.payload), message.retain)

    def _take(self, topic: str, payload: bytes, retained: bool) -> None:
        try:
            if len(payload) > self._limit:
                self._listener.on_too_large(topic, len(payload))
            else:
                self._listener.on_message(topic, payload, retained)
        except Exception as problem:
            if self._is_new(problem):
                LOG.exception("message of %d bytes", len(payload))

    def _is_new(self, problem: Exception) -> bool:
        """Tell whether a problem is not logged yet: the next message may fail in the same way."""
        name = repr(problem)
        if name in self._logged or len(self._logged) >= MOST_LOGGED:
            return False
        self._logged.add(name)
        return True

    def _on_subscribe(
        self, _client: mqtt.Client, _data: Any, number: int, codes: list[ReasonCode], _more: Any
    ) -> None:
        for pattern, code in zip(self._asked.pop(number, ()), codes, strict=False):
            self._listener.on_subscribed(pattern, code.value < FAILED)

    def _on_unsubscribe(
        self, _client: mqtt.Client, _data: Any, number: int, _codes: list[ReasonCode], _more: Any
    ) -> None:
        sent_at = self._beats.pop(number, None)
        if sent_at is not None:
            self._listener.on_answer(time.monotonic() - sent_at)


def _settle(phase: "asyncio.Future[Message]", reason: Message) -> None:
    """End a phase, once."""
    if not phase.done():
        phase.set_result(reason)


class PahoDriver:
    """Reads and writes a client's socket. On the network loop, but `connect`, which blocks, on any thread."""

    def __init__(self, client: FedClient, is_awaited: Callable[[], bool], fail: Callable[[], None]) -> None:
        """`is_awaited` tells whether an answer is: then each message is read at once. `fail` is called when
        the client can't go on: its server sends what is not MQTT."""
        self._client = client
        self._is_awaited = is_awaited
        self._fail = fail
        self._loop = asyncio.get_running_loop()
        self._is_listening = False
        self._resting: asyncio.Handle | None = None
        client.on_socket_open = self._on_socket_open
        client.on_socket_close = self._on_socket_close
        client.on_socket_register_write = self._on_writes
        client.on_socket_unregister_write = self._on_written

    def _on_socket_open(self, _client: mqtt.Client, _data: Any, sock: Any) -> None:
        self._loop.call_soon_threadsafe(self._listen, sock)

    def _listen(self, sock: Any) -> None:
        """Read as soon as something arrives, unless the socket is closed meanwhile."""
        current: Any = self._client.socket()
        if current is sock and not self._is_listening:
            self._stop_resting()
            self._is_listening = True
            self._loop.add_reader(sock, self._read)

    def _stop_listening(self, sock: Any) -> None:
        if self._is_listening:
            self._is_listening = False
            self._loop.remove_reader(sock)

    def _stop_resting(self) -> None:
        if self._resting is not None:
            self._resting.cancel()
            self._resting = None

    def _on_socket_close(self, _client: mqtt.Client, _data: Any, sock: Any) -> None:
        self._forget(sock)

    def _on_writes(self, _client: mqtt.Client, _data: Any, sock: Any) -> None:
        self._loop.call_soon_threadsafe(self._add_writer, sock)

    def _add_writer(self, sock: Any) -> None:
        current: Any = self._client.socket()
        if current is sock and self._client.want_write():
            self._loop.add_writer(sock, self.write)

    def _on_written(self, _client: mqtt.Client, _data: Any, sock: Any) -> None:
        self._loop.remove_writer(sock)

    def _forget(self, sock: Any) -> None:
        self._stop_resting()
        self._stop_listening(sock)
        self._loop.remove_writer(sock)

    def _read(self) -> None:
        """Read what has arrived, and then nothing for a moment: what arrives meanwhile is read together."""
        self._stop_resting()
        size = self._guarded(self._client.receive)
        sock: Any = self._client.socket()
        if sock is None:
            return
        # Under TLS the socket may hold more than the system tells.
        if size >= PIECE or (isinstance(sock, ssl.SSLSocket) and sock.fileno() >= 0 and sock.pending()):
            self._resting = self._loop.call_later(0, self._read)
        elif size and not self._is_awaited():
            self._stop_listening(sock)
            self._resting = self._loop.call_later(GATHER, self._read)
        else:
            self._listen(sock)

    def write(self) -> None:
        """Write what waits, and read the answer as soon as it arrives."""
        self._guarded(self._client.loop_write)
        sock: Any = self._client.socket()
        if sock is not None:
            self._listen(sock)

    def _guarded(self, do: Callable[[], int]) -> int:
        try:
            return do()
        except Exception:
            LOG.exception("paho")
            self._fail()
        return 0

    def close(self) -> None:
        """Close the connection: the broker hears of it if it can."""
        with suppress(OSError, ValueError):
            self._client.disconnect()
            self._client.loop_write()
        left: Any = self._client.socket()
        if left is not None:
            self._forget(left)
            left.close()
