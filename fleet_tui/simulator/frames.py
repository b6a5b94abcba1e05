"""Messages as rosbridge puts them on the wire: JSON with escaped slashes, PNG around it, or CBOR.

Kept apart from the client's codec on purpose: two sides that share one agree on each other's faults.
"""

import base64
import io
import json
import math
from collections.abc import Callable
from functools import cached_property
from typing import Any, Literal

import cbor2
import msgspec
import numpy as np
from numpy.typing import NDArray
from PIL import Image

Frame = str | bytes
"""A text or a binary WebSocket message."""

Compression = Literal["none", "png", "cbor", "cbor-raw"]

TAGS = {"int8": 72, "float32": 85, "float64": 86}  # the CBOR tags of RFC 8746 for little-endian arrays


class Floats:
    """A float32 array of any length: a list with nulls in JSON, a typed array in CBOR."""

    def __init__(self, values: NDArray[np.float32]) -> None:
        self.values = values


def _as_list(value: Any) -> Any:
    if isinstance(value, Floats):
        return value.values.tolist()
    if isinstance(value, np.ndarray):
        if value.dtype == np.uint8:
            return base64.standard_b64encode(value.tobytes()).decode()
        # An array of fixed length on ROS 2: the real bridge writes its NaN and Infinity as bare words.
        if value.dtype.kind == "f":
            return msgspec.Raw(json.dumps(value.tolist(), separators=(",", ":")).encode())
        return value.tolist()
    raise TypeError(f"{type(value)} has no place in a ROS message")


def _as_tag(encoder: cbor2.CBOREncoder, value: Any) -> None:
    if isinstance(value, Floats):
        value = value.values
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{type(value)} has no place in a ROS message")
    if value.dtype == np.uint8:
        encoder.encode(value.tolist())
        return
    encoder.encode(cbor2.CBORTag(TAGS[value.dtype.name], value.tobytes()))


_JSON = msgspec.json.Encoder(enc_hook=_as_list)


def to_json(value: Any) -> str:
    """JSON as the bridge writes it: no spaces, `/` escaped, NaN and infinities as null."""
    return _JSON.encode(value).replace(b"/", b"\\/").decode()


class Payload:
    """A message, encoded at most once in each way however many topics and clients it goes to.

    `raw` makes of it what cbor-raw carries: the time and the message as ROS itself encodes it.
    """

    def __init__(self, msg: Any, raw: Callable[[Any], Any] | None = None) -> None:
        self.msg = msg
        self._raw = raw

    @cached_property
    def json(self) -> str:
        return to_json(self.msg)

    @cached_property
    def cbor(self) -> bytes:
        return cbor2.dumps(self.msg, default=_as_tag)

    @cached_property
    def cbor_raw(self) -> bytes:
        return cbor2.dumps(self._raw(self.msg) if self._raw else self.msg, default=_as_tag)


class OutgoingFrame:
    """A payload on its way out on a topic: one frame for all clients of a compression."""

    def __init__(self, topic: str, payload: Payload) -> None:
        self._topic = topic
        self._payload = payload

    def frame(self, compression: Compression) -> Frame:
        """The frame for a client that asked for this compression."""
        if compression == "cbor":
            return self._cbor
        if compression == "cbor-raw":
            return self._cbor_raw
        return self._png if compression == "png" else self._text

    @cached_property
    def _text(self) -> str:
        return f'{{"op":"publish","topic":{to_json(self._topic)},"msg":{self._payload.json}}}'

    @cached_property
    def _cbor(self) -> bytes:
        return self._binary(self._payload.cbor)

    @cached_property
    def _cbor_raw(self) -> bytes:
        return self._binary(self._payload.cbor_raw)

    def _binary(self, msg: bytes) -> bytes:
        head = b"\xa3" + cbor2.dumps("op") + cbor2.dumps("publish") + cbor2.dumps("topic")
        return head + cbor2.dumps(self._topic) + cbor2.dumps("msg") + msg

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
