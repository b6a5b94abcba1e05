"""Drives a client of paho on the network loop, instead of a thread of its own."""

import asyncio
import fcntl
import logging
import ssl
import struct
import termios
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import paho.mqtt.client as mqtt

LOG = logging.getLogger(__name__)

BUSY, GATHER = 0.02, 0.01
"""Seconds between two reads from which messages are gathered, and for which they are."""


def _has_more(sock: Any) -> bool:
    """Tell whether bytes wait to be read. Under TLS a socket may hold more than the system tells, and less
    than a message."""
    if isinstance(sock, ssl.SSLSocket):
        return sock.fileno() >= 0 and sock.pending() > 0
    try:
        return bool(struct.unpack("i", fcntl.ioctl(sock, termios.FIONREAD, b"\0\0\0\0"))[0])
    except (OSError, ValueError):
        return False


class PahoDriver:
    """Reads and writes a client's socket. On the network loop, but `connect`, which blocks, on any thread."""

    def __init__(self, client: mqtt.Client, fail: Callable[[], None]) -> None:
        """`fail` is called when the client can't go on: its server sends what is not MQTT."""
        self._client, self._fail = client, fail
        self._loop = asyncio.get_running_loop()
        self._read_at = 0.0
        self._resting: asyncio.TimerHandle | None = None
        client.on_socket_open = self._on_socket_open
        client.on_socket_close = self._on_socket_close
        client.on_socket_register_write = self._on_writes
        client.on_socket_unregister_write = self._on_written

    def _on_socket_open(self, _client: mqtt.Client, _data: Any, sock: Any) -> None:
        self._loop.call_soon_threadsafe(self._listen, sock)

    def _listen(self, sock: Any) -> None:
        """Read as soon as something arrives, unless the socket is closed meanwhile."""
        current: Any = self._client.socket()
        if current is sock:
            self._loop.add_reader(sock, self._read)

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
        if self._resting is not None:
            self._resting.cancel()
        self._loop.remove_reader(sock)
        self._loop.remove_writer(sock)

    def _read(self) -> None:
        """Read what has arrived. While messages come one after the other, those of some milliseconds are read
        together: to wake up costs as much as to read."""
        self._guarded(self._client.loop_read)
        sock: Any = self._client.socket()
        while sock is not None and _has_more(sock):
            self._guarded(self._client.loop_read)
            sock = self._client.socket()
        now = self._loop.time()
        if sock is not None and now - self._read_at < BUSY:
            self._loop.remove_reader(sock)
            self._resting = self._loop.call_later(GATHER, self._listen, sock)
        self._read_at = now

    def write(self) -> None:
        """Write what waits."""
        self._guarded(self._client.loop_write)

    def _guarded(self, do: Callable[[], object]) -> None:
        try:
            do()
        except Exception:
            LOG.exception("paho")
            self._fail()

    def close(self) -> None:
        """Close the connection: the broker hears of it if it can."""
        with suppress(OSError, ValueError):
            self._client.disconnect()
            self._client.loop_write()
        left: Any = self._client.socket()
        if left is not None:
            self._forget(left)
            left.close()
