"""Messages that a bridge compressed as PNG."""

import base64
import gzip
import io
import json
import struct
import zlib
from pathlib import Path

import pytest
from PIL import Image

from fleet_tui.maps.png_text import text_of_png
from fleet_tui.robots.adapter import Limit
from fleet_tui.text.errors import WireError

WIRE = Path(__file__).parent.parent / "wire"


def recorded(name: str) -> list[str]:
    lines = gzip.decompress((WIRE / f"{name}.jsonl.gz").read_bytes()).splitlines()
    return [line["text"] for line in map(json.loads, lines) if line["dir"] == "in"]


def picture(width: int, height: int) -> str:
    """Return a picture of one pixel that claims this size."""
    file = io.BytesIO()
    Image.new("RGB", (1, 1)).save(file, "png")
    claims = bytearray(file.getvalue())
    claims[16:24] = struct.pack(">II", width, height)
    claims[29:33] = struct.pack(">I", zlib.crc32(claims[12:29]))
    return base64.b64encode(claims).decode()


def test_a_recorded_picture_has_the_map_that_was_recorded_as_json() -> None:
    packed = next(json.loads(text) for text in recorded("ros2-map-png"))
    plain = next(frame for frame in map(json.loads, recorded("ros2-map-json")) if frame["op"] == "publish")
    frame = json.loads(text_of_png(packed["data"], Limit(64.0, "")))
    assert (frame["op"], frame["topic"]) == ("publish", plain["topic"])
    assert (frame["msg"]["info"], frame["msg"]["data"]) == (plain["msg"]["info"], plain["msg"]["data"])


@pytest.mark.parametrize(
    ("data", "limit", "reason"),
    [
        (picture(1000, 1000), 2.9, "3.0 MB exceeds the limit of 2.9 MB: raise rosbridge.max"),
        (picture(15000, 15000)[:200], 2000.0, "unreadable: "),
        (picture(9, 9)[:60], 64.0, "unreadable: "),
        ("%", 64.0, "unreadable: "),
        ("", 64.0, "unreadable: "),
    ],
)
def test_what_is_no_picture_or_too_large_a_one_is_named(data: str, limit: float, reason: str) -> None:
    with pytest.raises(WireError, match=reason):
        text_of_png(data, Limit(limit, "rosbridge.max_message_mb"))
