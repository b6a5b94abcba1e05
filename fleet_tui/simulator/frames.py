"""Messages as rosbridge puts them on the wire: JSON with escaped slashes, PNG around it, or CBOR.

Kept apart from the client's codec on purpose: two sides that share one agree on each other's faults.
"""

import base64
import io
import math
from functools import cached_property
from typing import Any, Literal

import cbor2
import msgspec
import numpy as np
from PIL import Image

Frame = str | bytes
"""A text or a binary WebSocket message."""

Compression = Literal["none", "png", "cbor"]

INT8_ARRAY = 72  # the CBOR tag of RFC 8746


def _as_list(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    raise TypeError(f"{type(value)} has no place in a ROS message")


def _as_tag(encoder: cbor2.CBOREncoder, value: Any) -> None:
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{type(value)} has no place in a ROS message")
    encoder.encode(cbor2.CBORTag(INT8_ARRAY, value.tobytes()))


_JSON = msgspec.json.Encoder(enc_hook=_as_list)


def to_json(value: Any) -> str:
    """JSON as the bridge writes it: no spaces, `/` escaped, NaN and infinities as null."""
    return _JSON.encode(value).replace(b"/", b"\\/").decode()


class Payload:
    """A message, encoded at most once in each way however many topics and clients it goes to."""

    def __init__(self, msg: Any) -> None:
        self._msg = msg

    @cached_property
    def json(self) -> str:
        """The message as JSON."""
        return to_json(self._msg)

    @cached_property
    def cbor(self) -> bytes:
        """The message as CBOR, int8 arrays as typed arrays."""
        return cbor2.dumps(self._msg, default=_as_tag)


class Publication:
    """A payload on its way out on a topic: one frame for all clients of a compression."""

    def __init__(self, topic: str, payload: Payload) -> None:
        self._topic, self._payload = topic, payload

    def frame(self, compression: Compression) -> Frame:
        """The frame for a client that asked for this compression."""
        if compression == "cbor":
            return self._cbor
        return self._png if compression == "png" else self._text

    @cached_property
    def _text(self) -> str:
        return f'{{"op":"publish","topic":{to_json(self._topic)},"msg":{self._payload.json}}}'

    @cached_property
    def _cbor(self) -> bytes:
        head = b"\xa3" + cbor2.dumps("op") + cbor2.dumps("publish") + cbor2.dumps("topic")
        return head + cbor2.dumps(self._topic) + cbor2.dumps("msg") + self._payload.cbor

    @cached_property
    def _png(self) -> str:
        return to_json({"op": "png", "data": _picture(self._text.encode())})


def _picture(text: bytes) -> str:
    """The text as the pixels of an about square RGB picture, padded with newlines, in base64."""
    width = max(1, math.isqrt(len(text) // 3))
    height = math.ceil(len(text) / (3 * width))
    picture = Image.frombytes("RGB", (width, height), text.ljust(3 * width * height, b"\n"))
    file = io.BytesIO()
    picture.save(file, "png")
    return base64.standard_b64encode(file.getvalue()).decode()
