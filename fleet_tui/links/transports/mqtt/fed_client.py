"""A client of paho that is fed: its socket is read in large pieces, and most messages are read here.

By itself paho reads three times for a message, and keeps much of it that nobody needs: at 1,200 messages a
second that is a third of what the console does with them.
"""

from collections.abc import Callable
from typing import Any

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

PIECE = 65536
"""Maximum bytes that are read at once."""
PUBLISH = 0x30
RETAINED = 0x01
"""First byte of a message with QoS 0 that is no repetition, and its bit for one that the broker had kept."""
MOST_LENGTH = 4
"""Maximum bytes of a packet's length, each with seven bits of it."""

Take = Callable[[str, bytes, bool], None]
"""Takes a message: its topic, its payload, whether the broker had kept it."""


class FedClient(mqtt.Client):
    """A client of MQTT 3.1.1 with a clean session. `take` gets messages with QoS 0; paho everything else."""

    def __init__(self, client_id: str, take: Take) -> None:
        super().__init__(
            CallbackAPIVersion.VERSION2,
            client_id,
            clean_session=True,
            protocol=mqtt.MQTTv311,
            reconnect_on_failure=False,
        )
        self._take = take
        self._unread = bytearray()
        self._lent = bytearray()
        """Bytes that have arrived, and those of them that are for paho now."""
        self._is_over = False

    def receive(self) -> int:
        """Read what has arrived, at most a piece, and return its number of bytes. Whole packets are handled;
        the end of the connection is, too."""
        try:
            piece = super()._sock_recv(PIECE)
        except BlockingIOError:
            return 0
        except OSError:
            piece = b""
        self._is_over = not piece
        self._unread += piece
        while self._handle_next():
            pass
        if self._is_over:
            self.loop_read()
        return len(piece)

    def _handle_next(self) -> bool:
        """Handle the first packet that has not been handled, and tell whether it had arrived whole."""
        start, length = _extent(self._unread)
        if length < 0 or len(self._unread) < start + length or self.socket() is None:
            return False
        packet = self._unread[: start + length]
        del self._unread[: start + length]
        if packet[0] & ~RETAINED != PUBLISH or not self._taken(packet, start):
            self._lent = packet
            while self._lent and self.socket() is not None:
                self.loop_read()
        return True

    def _taken(self, packet: bytearray, start: int) -> bool:
        """Take a message whose topic begins at `start`, unless it is too short for that topic."""
        end = start + 2 + int.from_bytes(packet[start : start + 2], "big")
        if end > len(packet):
            return False
        try:
            topic = packet[start + 2 : end].decode()
        except UnicodeDecodeError:
            return False
        self._take(topic, bytes(packet[end:]), bool(packet[0] & RETAINED))
        return True

    def _sock_recv(self, bufsize: int) -> Any:
        """Return bytes of the packet that is for paho now, which believes that it reads its socket."""
        if not self._lent and not self._is_over:
            raise BlockingIOError
        piece = bytes(self._lent[:bufsize])
        del self._lent[:bufsize]
        return piece


def _extent(data: bytearray) -> tuple[int, int]:
    """Return where the first packet's content begins, and its length: below 0 if that has not arrived. One
    that is too long to be a length counts as 0: paho ends such a connection."""
    length = 0
    for n, byte in enumerate(data[1 : 1 + MOST_LENGTH]):
        length |= (byte & 127) << 7 * n
        if byte < 128:
            return n + 2, length
    start = MOST_LENGTH + 2
    return start, 0 if len(data) >= start else -1
