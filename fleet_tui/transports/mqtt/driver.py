"""Drives a client of paho on the network loop, instead of a thread of its own."""

import asyncio
import logging
import ssl
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import paho.mqtt.client as mqtt

from fleet_tui.transports.mqtt.fed_client import PIECE, FedClient

LOG = logging.getLogger(__name__)

GATHER = 0.04
"""Seconds for which messages are gathered after a read: to wake up costs as much as to read."""


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
