"""roslibpy with its gaps closed. The only module that imports it; pinned to 2.1.0.

Left alone it queues what is sent while the link is down and fires it on reconnect, backs off to an
hour, never notices a frozen server, can't read binary frames and complains on stderr.
"""

import asyncio
import logging
import random
import ssl
from typing import Any, Protocol, cast

import roslibpy
from roslibpy.comm.comm_asyncio import (
    AsyncioRosBridgeClientFactory,
    AsyncioRosBridgeProtocol,
    _get_shared_manager,
)

from fleet_tui.errors import LinkError

LOG = logging.getLogger(__name__)

FIRST_DELAY, LONGEST_DELAY, JITTER = 1.0, 5.0, 0.1
# A connection that lived this long was a good one: the next loss is tried again quickly.
SETTLED_AFTER = 5.0
CONNECT_TIMEOUT = 5.0
PING_INTERVAL = PING_TIMEOUT = 3.0
MAX_MESSAGE_BYTES = 512 * 2**20


class Listener(Protocol):
    """Who hears of a connection. Everything is called on the network loop."""

    def on_connecting(self) -> None:
        """A try has begun."""

    def on_open(self) -> None:
        """Frames can be sent."""

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """There is no connection; it is tried again in so many seconds."""

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """A frame came."""


def network_loop() -> asyncio.AbstractEventLoop:
    """The loop all connections share, in its own thread; started if need be."""
    manager = _get_shared_manager()
    manager.run()
    return cast("asyncio.AbstractEventLoop", manager.loop)


class _Protocol(AsyncioRosBridgeProtocol):  # type: ignore[misc]  # roslibpy has no types
    """Hands whole frames to the listener instead of decoding them itself."""

    def onMessage(self, payload: bytes, isBinary: bool) -> None:  # noqa: N802, N803  # autobahn's names
        try:
            self.factory.listener.on_frame(payload, isBinary)
        except Exception:
            LOG.exception("frame of %d bytes", len(payload))

    def onClose(self, wasClean: bool, code: int, reason: str | None) -> None:  # noqa: N802, N803  # autobahn's names
        if self.factory is not None:
            self.factory.reason = _plain(code, reason)
        super().onClose(wasClean, code, reason)


def _plain(code: int, reason: str | None) -> str:
    """Why a connection ended, in plain words."""
    text = reason or ""
    if "upgrade failed" in text or "HTTP" in text:
        return "the server there is no rosbridge: " + (text.partition("(")[2].rstrip(")") or text)
    if "did not perform opening handshake" in text or "opening handshake" in text:
        return "the server there does not answer"
    if "ping timeout" in text or "pong" in text:
        return "the server stopped answering"
    return {1000: "closed by the server", 1001: "the server went away"}.get(code, "connection lost")


class _Factory(AsyncioRosBridgeClientFactory):  # type: ignore[misc]  # roslibpy has no types
    """Tries for ever, at most every second, at least every five, and says what it is doing."""

    protocol = _Protocol

    def __init__(self, url: str, listener: Listener) -> None:
        super().__init__(url)
        self.listener = listener
        self.reason = ""
        self._opened_at = 0.0
        self._reconnect_delay: float = FIRST_DELAY
        self._timer: asyncio.TimerHandle | None = None
        self.setProtocolOptions(
            autoPingInterval=PING_INTERVAL,
            autoPingTimeout=PING_TIMEOUT,
            openHandshakeTimeout=CONNECT_TIMEOUT,
            closeHandshakeTimeout=1,
            maxMessagePayloadSize=MAX_MESSAGE_BYTES,
            maxFramePayloadSize=MAX_MESSAGE_BYTES,
            tcpNoDelay=True,
            # The decoder finds bad UTF-8, without going through 54 MB of a map first.
            utf8validateIncoming=False,
        )

    def ready(self, proto: _Protocol) -> None:
        """The handshake is done."""
        delay = self._reconnect_delay
        super().ready(proto)
        # A server that accepts and drops at once must not be asked ever faster.
        self._reconnect_delay = delay
        self._opened_at = self.manager.loop.time()
        self.listener.on_open()

    def connection_lost(self, proto: _Protocol) -> None:
        """The connection is gone, whoever ended it."""
        lived = self.manager.loop.time() - self._opened_at if self._opened_at else 0.0
        if lived > SETTLED_AFTER:
            self._reconnect_delay = FIRST_DELAY
        self._opened_at = 0.0
        super().connection_lost(proto)

    def stop(self) -> None:
        """Never try again. On the loop."""
        self._stop = True
        if self._timer is not None:
            self._timer.cancel()

    async def _connect_async(self) -> None:
        if self._stop:
            return
        self.listener.on_connecting()
        loop = self.manager.loop
        secure = ssl.create_default_context() if self.isSecure else None
        try:
            connecting = loop.create_connection(self, self.host, self.port, ssl=secure)
            await asyncio.wait_for(connecting, CONNECT_TIMEOUT)
        except (OSError, TimeoutError, ssl.SSLError, ValueError) as problem:
            self.reason = _refusal(problem)
            self._schedule_reconnect()

    def _schedule_reconnect(self) -> None:
        if self._stop:
            return
        delay = self._reconnect_delay
        self._reconnect_delay = min(delay * 1.7, LONGEST_DELAY / (1 + JITTER))
        wait = delay * (1 + random.random() * JITTER)
        self.listener.on_lost(self.reason, wait)
        self._timer = self.manager.loop.call_later(wait, self._open_connection)


def _refusal(problem: Exception) -> str:
    """Why no connection was made, in plain words."""
    match problem:
        case ConnectionRefusedError():
            return "nothing listens there"
        case TimeoutError():
            return "no answer from that address"
        case ssl.SSLError():
            return f"TLS: {problem.reason or problem}".lower()
        case OSError(errno=errno) if errno is not None and errno < 0:
            return "no such host"
        case _:
            return str(problem) or type(problem).__name__


class Connection(roslibpy.Ros):  # type: ignore[misc]  # roslibpy has no types
    """One WebSocket to a bridge that sends now or not at all."""

    def __init__(self, url: str, listener: Listener) -> None:
        # Not the base's: that one picks the factory itself and connects at once.
        self._id_counter = 0
        self.factory = _Factory(url, listener)
        self.is_connecting = False

    def send(self, payload: bytes) -> None:
        """Send a frame. On the loop. Raises LinkError without a connection."""
        proto = self.factory._proto
        if proto is None or proto._manual_disconnect:
            raise LinkError("no link")
        proto.sendMessage(payload, isBinary=False)

    def _refuse_without_link(self) -> None:
        if not self.is_connected:
            raise LinkError("no link")

    def send_on_ready(self, message: Any) -> None:
        """Like the base, but without a link nothing is kept for later. Raises LinkError."""
        self._refuse_without_link()
        super().send_on_ready(message)

    def call_async_service(self, message: Any, callback: Any, errback: Any) -> None:
        """Like the base, but without a link nothing is kept for later. Raises LinkError."""
        self._refuse_without_link()
        super().call_async_service(message, callback, errback)

    def shut(self) -> None:
        """Close, and never connect again. On the loop."""
        self.factory.stop()
        proto = self.factory._proto
        if proto is not None:
            proto._manual_disconnect = True
            proto.sendClose()
