"""Bytes on their way to a bridge: in our buffer, or without the acknowledgement of its computer."""

import fcntl
import struct
import sys
import termios
from contextlib import suppress

from fleet_tui.links.transports.rosbridge.connection import Connection


def unsent(connection: Connection) -> int:
    """Return the bytes that have not reached the other computer, as far as this system tells; 0 without a
    connection."""
    proto = connection.factory._proto
    transport = proto.transport if proto is not None else None
    if transport is None or transport.is_closing():
        return 0
    waiting: int = transport.get_write_buffer_size()
    socket = transport.get_extra_info("socket")
    if not waiting and socket is not None and sys.platform == "linux":
        with suppress(OSError):
            (waiting,) = struct.unpack("i", fcntl.ioctl(socket.fileno(), termios.TIOCOUTQ, b"\0" * 4))
    return waiting
