"""Messages of cameras: sensor_msgs/CompressedImage."""

import binascii
from typing import Any

import msgspec

from fleet_tui.model.set_up.streams import CameraImage
from fleet_tui.robots.ros import messages as ros
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, truncate
from fleet_tui.text.sanitize import sanitize

MOST_BYTES = 4_000_000
"""Bytes of a compressed picture above which it is not shown."""
JPEG = b"\xff\xd8\xff"
PNG = b"\x89PNG\r\n\x1a\n"
_BASE64 = 4 / 3


class _ImageMessage(msgspec.Struct, frozen=True):
    """sensor_msgs/CompressedImage: its data is base64 in JSON, bytes in CBOR."""

    data: Any
    format: str = ""
    header: ros.Header = ros.Header("")


_read_image = ros.reader(_ImageMessage)


def read_image(msg: object) -> CameraImage:
    """Read a compressed picture, which is not decoded here. A large one, or one of another format than JPEG
    and PNG, has only the reason that it is not shown. Raises WireError."""
    message = _read_image(msg)
    stamp, given = message.header.stamp.seconds, message.data
    if not isinstance(given, str | bytes):
        raise WireError("data: neither base64 nor bytes")
    size = len(given) / _BASE64 if isinstance(given, str) else len(given)
    if size > MOST_BYTES + 2:
        too_large = Message(
            "{size} MB a picture, the limit is {most_bytes} MB: lower its quality",
            size=f"{size / 1000000.0:.1f}",
            most_bytes=f"{MOST_BYTES / 1000000.0:g}",
        )
        return CameraImage(b"", stamp, too_large)
    data = _bytes(given)
    # Depth as PNG is named by its format alone: its numbers are no colours.
    is_depth = "compresseddepth" in message.format.lower()
    if is_depth or not data.startswith((JPEG, PNG)):
        named = sanitize(truncate(message.format, LONGEST_NAME)) or "unnamed"
        return CameraImage(b"", stamp, Message("format {named} is not shown, only JPEG and PNG", named=named))
    return CameraImage(data, stamp)


def _bytes(given: str | bytes) -> bytes:
    if isinstance(given, bytes):
        return given
    try:
        return binascii.a2b_base64(given, strict_mode=True)
    except (binascii.Error, ValueError) as problem:
        raise WireError(f"data: {problem}") from None
