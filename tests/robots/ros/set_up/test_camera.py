"""Pictures of cameras from the wire: base64 and bytes, other formats, too large ones."""

import base64
import json
from typing import Any

import cbor2
import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.robots.ros.cbor import read_cbor
from fleet_tui.robots.ros.set_up.camera import JPEG, MOST_BYTES, PNG, read_image
from fleet_tui.text.errors import WireError

HEADER = {"frame_id": "/lens", "stamp": {"sec": 7, "nanosec": 500_000_000}}
FILE = JPEG + bytes(range(256))


def image(data: object, format_: str = "jpeg") -> dict[str, Any]:
    return {"header": HEADER, "format": format_, "data": data}


def test_base64_in_json_and_bytes_in_cbor_are_the_same_picture() -> None:
    text = image(base64.standard_b64encode(FILE).decode())
    for msg in (msgspec.Raw(json.dumps(text).encode()), image(FILE, "rgb8; jpeg compressed bgr8")):
        found = read_image(msg)
        assert (found.data, found.stamp, found.unshown) == (FILE, 7.5, "")
    assert read_image(image(PNG, "png")).data == PNG


def test_a_picture_of_megabytes_is_read_from_cbor() -> None:
    data = JPEG + bytes(2**21)
    frame = read_cbor(cbor2.dumps({"op": "publish", "topic": "/camera", "msg": image(data)}))
    assert read_image(frame["msg"]).data == data


@pytest.mark.parametrize(
    ("data", "format_", "reason"),
    [
        (PNG, "16UC1; compressedDepth", "format 16UC1; compressedDepth is not shown"),
        (b"rvl", "16UC1; compressedDepth rvl", "rvl is not shown, only JPEG and PNG"),
        (b"RIFF", "webp\x1b[2J", "format webp␛[2J is not shown"),
        (b"", "", "format unnamed is not shown"),
        (JPEG + bytes(MOST_BYTES), "jpeg", "4.0 MB a picture, the limit is 4 MB: lower its quality"),
        ("A" * (2 * MOST_BYTES), "jpeg", "6.0 MB a picture, the limit is 4 MB: lower its quality"),
    ],
)
def test_what_is_not_shown_is_named(data: object, format_: str, reason: str) -> None:
    found = read_image(image(data, format_))
    assert reason in found.unshown and not found.data


@pytest.mark.parametrize("data", [None, 7, [1, 2], "no base64!", "äöü", {}])
def test_data_that_is_no_file_is_refused(data: object) -> None:
    with pytest.raises(WireError, match="data"):
        read_image(image(data))


@given(
    st.dictionaries(st.sampled_from(["header", "format", "data"]), st.text() | st.binary() | st.integers())
)
def test_no_message_is_more_than_refused(msg: dict[str, object]) -> None:
    try:
        found = read_image(msg)
    except WireError:
        return
    assert bool(found.data) != bool(found.unshown)
