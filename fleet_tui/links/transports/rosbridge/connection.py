"""Connections to a rosbridge: opened, pinged, and opened again after a loss. The only module that uses
roslibpy; pinned to 2.1.0.

By itself that sends queued messages on reconnect, backs off to an hour, never detects a frozen server, can't
read binary frames and prints errors on stderr.
"""

import asyncio
import hashlib
import logging
import platform
import random
import secrets
import ssl
import time
from typing import Any, Protocol

import msgspec

from fleet_tui.config.access import hidden, secret
from fleet_tui.config.schema import Link
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.links.transports.reasons import refusal
from fleet_tui.links.transports.rosbridge.library import comm_asyncio, roslibpy
from fleet_tui.links.transports.rosbridge.reasons import ended, failed_handshake
from fleet_tui.links.transports.tls import tls_context
from fleet_tui.text.errors import FleetError, LinkError
from fleet_tui.text.language import EMPTY, Message

LOG = logging.getLogger(__name__)

FIRST_DELAY = 1.0
LONGEST_DELAY = 5.0
JITTER = 0.25
# After a connection of this length the next loss is retried quickly.
SETTLED_AFTER = 5.0
CONNECT_TIMEOUT = 5.0
PING_INTERVAL = PING_TIMEOUT = 3.0
# Closed sooner after opening, the server rejected the connection.
AT_ONCE = 1.0
# Bytes kept of a message that is too large: enough to identify its topic.
HEAD = 1000


# Seconds of the requested session. rosauth checks it only once, when the connection begins.
SESSION = 86_400


class Listener(Protocol):
    """Receives the events of a connection. Everything is called on the network loop."""

    def on_connecting(self) -> None:
        """A connection attempt has begun."""

    def on_open(self) -> None:
        """Frames can be sent."""

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """Take the loss of the connection; the next try is in `next_try_in` seconds."""

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """A frame arrived."""

    def on_sent(self, payload: bytes) -> None:
        """A frame was sent."""

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """A message of `size` bytes was dropped; `head` is its beginning."""


class _OwnLoop(comm_asyncio.AsyncioEventLoopManager):  # type: ignore[misc]  # roslibpy has no types
    """Runs roslibpy on our loop instead of its own."""

    def run(self) -> None:
        self.loop = network_loop()


comm_asyncio._MANAGER_SINGLETON = _OwnLoop()


class _Protocol(comm_asyncio.AsyncioRosBridgeProtocol):  # type: ignore[misc]  # roslibpy has no types
    """Passes whole messages to the listener undecoded, and drops those that are too large."""

    lost_by: Exception | None = None
    message_data: list[bytes]
    frame_data: list[bytes]

    def data_received(self, data: bytes) -> None:
        self.factory.fed_at = self.factory.manager.loop.time()
        self.factory.read_bytes += len(data)
        super().data_received(data)

    def onAutoPingTimeout(self) -> None:  # noqa: N802  # autobahn's name
        # The answer to a ping waits behind a long message: any arriving data is a sign of life.
        if self.factory.manager.loop.time() - self.factory.fed_at > PING_TIMEOUT:
            super().onAutoPingTimeout()
            return
        later = self.factory._batched_timer.call_later
        self.autoPingTimeoutCall = later(PING_TIMEOUT, self.onAutoPingTimeout)

    def onMessageBegin(self, isBinary: bool) -> None:  # noqa: N802, N803  # autobahn's names
        super().onMessageBegin(isBinary)
        self._head = b""

    def onMessageFrameBegin(self, length: int) -> None:  # noqa: N802  # autobahn's name
        # Not the base's: that one fails the connection, and the next one would get the same message.
        self.frame_length = length
        self.frame_data = []
        self.message_data_total_length += length

    def onMessageFrameData(self, payload: bytes) -> None:  # noqa: N802  # autobahn's name
        if self.message_data_total_length <= self.factory.limit:
            super().onMessageFrameData(payload)
        elif not self._head:
            self._head = b"".join([*self.message_data[:1], *self.frame_data[:1], payload])[:HEAD]
            self.message_data = []
            self.frame_data = []

    def onMessageEnd(self) -> None:  # noqa: N802  # autobahn's name
        if not self._head:
            super().onMessageEnd()
            return
        head, size = hidden(self._head), self.message_data_total_length
        self.factory.listener.on_too_large(head, self.message_is_binary, size)

    def _max_message_size_exceeded(self, msg_size: int, max_msg_size: int, reason: str) -> None:
        # A compressed message can't be skipped: from the next connection on there are none.
        self.factory.setProtocolOptions(perMessageCompressionOffers=[])
        super()._max_message_size_exceeded(msg_size, max_msg_size, reason)

    def onMessage(self, payload: bytes, isBinary: bool) -> None:  # noqa: N802, N803  # autobahn's names
        try:
            self.factory.listener.on_frame(hidden(payload), isBinary)
        except Exception:
            LOG.exception("frame of %d bytes", len(payload))

    def connection_lost(self, exc: Exception | None) -> None:
        self.lost_by = exc
        super().connection_lost(exc)

    def onClose(self, wasClean: bool, code: int, reason: str | None) -> None:  # noqa: N802, N803  # autobahn's names
        if self.factory is not None:
            said = (reason or "").encode(errors="replace")
            reason = hidden(said).decode(errors="replace")
            self.factory.reason = self.factory.why_closed(code, reason, self.lost_by)
        super().onClose(wasClean, code, reason)


class _Factory(comm_asyncio.AsyncioRosBridgeClientFactory):  # type: ignore[misc]  # roslibpy has no types
    """Reconnects forever, after one to five seconds, and reports its state."""

    protocol = _Protocol

    def __init__(self, bridge: Link, listener: Listener) -> None:
        super().__init__(bridge.url)
        self._bridge = bridge
        self.credentials = Credentials(bridge)
        self.listener = listener
        self.limit = int(bridge.max_message_mb * 1e6)
        self.reason = EMPTY
        self.read_bytes = 0
        self.fed_at = 0.0
        self._opened_at = 0.0
        self._reconnect_delay: float = FIRST_DELAY
        self._timer: asyncio.TimerHandle | None = None
        self._trying: asyncio.Task[None] | None = None  # held, or it may be garbage-collected while running
        self.setProtocolOptions(
            autoPingInterval=PING_INTERVAL,
            autoPingTimeout=PING_TIMEOUT,
            openHandshakeTimeout=CONNECT_TIMEOUT,
            closeHandshakeTimeout=1,
            maxMessagePayloadSize=self.limit,
            tcpNoDelay=True,
            # The decoder detects bad UTF-8, without scanning 54 MB of a map first.
            utf8validateIncoming=False,
        )

    def ready(self, proto: _Protocol) -> None:
        """Report the completed handshake."""
        if self._stop:
            proto.transport.abort()
            return
        delay = self._reconnect_delay
        super().ready(proto)
        self._reconnect_delay = delay  # a server that drops at once must not be retried ever faster
        self._opened_at = self.manager.loop.time()
        if first := self.credentials.frame(self.host):
            proto.sendMessage(first)
        self.listener.on_open()

    def connection_lost(self, proto: _Protocol) -> None:
        """Report the loss, whichever side ended it."""
        lived = self.manager.loop.time() - self._opened_at if self._opened_at else 0.0
        if lived > SETTLED_AFTER:
            self._reconnect_delay = FIRST_DELAY
        self._opened_at = 0.0
        super().connection_lost(proto)

    def why_closed(self, code: int, text: str, lost_by: Exception | None) -> str:
        """Return the reason that a connection ended, in plain words; `text` is autobahn's."""
        if not self._opened_at:
            return failed_handshake(text, self._bridge, lost_by)
        if isinstance(lost_by, ssl.SSLError):
            return refusal(lost_by, self._bridge)
        return ended(code, text, self._bridge, self.manager.loop.time() - self._opened_at < AT_ONCE)

    def stop(self) -> None:
        """Stop reconnecting. On the loop."""
        self._stop = True
        for pending in (self._timer, self._trying):
            if pending is not None:
                pending.cancel()

    def _open_connection(self) -> None:
        self._trying = asyncio.ensure_future(self._connect_async())

    async def _connect_async(self) -> None:
        if self._stop:
            return
        self.listener.on_connecting()
        try:
            async with asyncio.timeout(CONNECT_TIMEOUT):
                secure = await self._be_let_in()
                await self.manager.loop.create_connection(self, self.host, self.port, ssl=secure)
        except (OSError, ValueError, FleetError) as problem:
            self.reason = refusal(problem, self._bridge)
            self._schedule_reconnect()

    async def _be_let_in(self) -> ssl.SSLContext | None:
        """Read secrets and certificates again: they may have been renewed."""
        self.credentials.read()
        self.headers = self.credentials.headers
        return await asyncio.to_thread(tls_context, self._bridge) if self._bridge.is_secure else None

    def _schedule_reconnect(self) -> None:
        if self._stop:
            return
        wait = self._reconnect_delay * (1 + random.random() * JITTER)
        self._reconnect_delay = min(self._reconnect_delay * 1.7, LONGEST_DELAY / (1 + JITTER))
        self.listener.on_lost(self.reason, wait)
        self._timer = self.manager.loop.call_later(wait, self._open_connection)


class Connection(roslibpy.Ros):  # type: ignore[misc]  # roslibpy has no types
    """One WebSocket to a bridge that sends now or not at all."""

    def __init__(self, bridge: Link, listener: Listener) -> None:
        # Not the base's: that one picks the factory itself and connects at once.
        self._id_counter = 0
        self.factory = _Factory(bridge, listener)
        self.is_connecting = False

    def progress(self) -> tuple[int, int]:
        """Return the bytes ever read, and the socket's file descriptor, -1 without one."""
        transport = self.factory._proto.transport if self.is_connected else None
        found = transport.get_extra_info("socket") if transport is not None else None
        return self.factory.read_bytes, -1 if found is None else found.fileno()

    def send(self, payload: bytes) -> None:
        """Send a frame. On the loop. Raises LinkError without a connection."""
        self._refuse_without_link()
        self.factory._proto.sendMessage(payload, isBinary=False)
        self.factory.listener.on_sent(payload)

    def _refuse_without_link(self) -> None:
        # After a server's close frame the connection stays open, and accepts nothing, until one side ends it.
        if not self.is_connected or self.factory._proto.state != _Protocol.STATE_OPEN:
            raise LinkError(Message("no link"))

    def send_on_ready(self, message: Any) -> None:
        """Send like the base, but without a link nothing is queued. Raises LinkError."""
        self._refuse_without_link()
        super().send_on_ready(message)

    def call_async_service(self, message: Any, callback: Any, errback: Any) -> None:
        """Call like the base, but without a link nothing is queued. Raises LinkError."""
        self._refuse_without_link()
        super().call_async_service(message, callback, errback)

    def shut(self) -> None:
        """Close permanently. On the loop."""
        self.factory.stop()
        proto = self.factory._proto
        if proto is not None:
            proto._manual_disconnect = True
            proto.sendClose()


def auth(secret: str, client: str, dest: str, rand: str, now: int) -> bytes:
    """Return the frame that proves to a rosauth server, at Unix second `now`, that we know its secret.

    Source: ROSBRIDGE_PROTOCOL.md (auth) and rosauth's ros_mac_authentication: SHA-512 over the secret and the
    fields as they are sent.
    """
    level, end = "operator", now + SESSION
    mac = hashlib.sha512(f"{secret}{client}{dest}{rand}{now}{level}{end}".encode()).hexdigest()
    fields = {"mac": mac, "client": client, "dest": dest, "rand": rand, "t": now, "level": level, "end": end}
    return msgspec.json.encode({"op": "auth", **fields})


class Credentials:
    """The secrets of one link, as of the last attempt."""

    def __init__(self, bridge: Link) -> None:
        self._bridge = bridge
        self._rosauth = ""
        self.headers: dict[str, str] = {}

    def read(self) -> None:
        """Read them again: they may have been renewed. Raises ConfigError."""
        authorization = secret(self._bridge, "authorization")
        self.headers = {"Authorization": authorization} if authorization else {}
        self._rosauth = secret(self._bridge, "rosauth")

    def frame(self, host: str) -> bytes:
        """Return the first frame of a connection, empty if the bridge needs none."""
        if not self._rosauth:
            return b""
        rand, now = secrets.token_hex(16), int(time.time())
        return auth(self._rosauth, platform.node(), host, rand, now)
