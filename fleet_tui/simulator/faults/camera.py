"""Faults of cameras, of robots of any kind."""

import struct
import zlib
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from fleet_tui.simulator.faults.plays import Faults, every

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.frames import Payload
    from fleet_tui.simulator.server import RosbridgeServer

STOPS = 5.0  # seconds after which it sends no more pictures
HUGE = 30_000  # pixels of each side of a picture


def _name(robot: str) -> str:
    from fleet_tui.simulator.senses.camera import NAME

    return f"/{robot}/{NAME}"


def _changed(server: "RosbridgeServer", robot: str, change: Callable[[bytes], bytes]) -> None:
    """Send changed files instead of the pictures."""
    topic = server.bridge.topics[_name(robot)]

    def payload(now: float) -> "Payload":
        from fleet_tui.simulator.senses.camera import message

        msg = topic.payload(now).msg
        return message(msg["header"], change(msg["data"]), msg["format"])

    server.bridge.topics[topic.name] = replace(topic, payload=payload)


def truncated(server: "RosbridgeServer", robot: str) -> None:
    _changed(server, robot, lambda data: data[: len(data) // 2])


def huge(server: "RosbridgeServer", robot: str) -> None:
    """Send a small file that claims to be a picture of almost a billion pixels."""
    head = b"IHDR" + struct.pack(">IIBBBBB", HUGE, HUGE, 8, 2, 0, 0, 0)
    file = b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + head + struct.pack(">I", zlib.crc32(head))
    rest = b"IDAT" + zlib.compress(bytes(1000))
    file += struct.pack(">I", len(rest) - 4) + rest + struct.pack(">I", zlib.crc32(rest))
    _changed(server, robot, lambda _: file)


def stops(server: "RosbridgeServer", robot: str) -> None:
    every(server, robot, STOPS, lambda: server.bridge.muted.add(_name(robot)))


FAULTS: Faults = {
    "camera-truncated": ("the camera sends half pictures", truncated),
    "camera-huge": ("the camera's pictures claim to have almost a billion pixels", huge),
    "camera-stops": (f"the camera stops after {STOPS:g} s", stops),
}
