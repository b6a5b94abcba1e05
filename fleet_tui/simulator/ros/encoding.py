"""ROS's own binary encodings of messages, as cbor-raw carries them."""

import struct
from typing import Any

import numpy as np

from fleet_tui.simulator.ros.definitions import Fields, RosField
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.filling import INTEGERS

_FORMATS = {"bool": "?", "float32": "f", "float64": "d"} | {
    name: {8: "b", 16: "h", 32: "i", 64: "q"}[bits] if signed else {8: "B", 16: "H", 32: "I", 64: "Q"}[bits]
    for name, (bits, signed) in INTEGERS.items()
}


def encode(dialect: Dialect, type_: str, msg: Message) -> bytes:
    """A message as ROS 1 serializes it, or as little-endian CDR with its header."""
    encoder = _Encoder(dialect)
    encoder.message(dialect.fields(type_) or {}, msg)
    return (b"\x00\x01\x00\x00" if dialect.aligned else b"") + bytes(encoder.data)


class _Encoder:
    def __init__(self, dialect: Dialect) -> None:
        self.data = bytearray()
        self._dialect = dialect
        self._aligned = dialect.aligned

    def message(self, fields: Fields, msg: Message) -> None:
        for name, field in fields.items():
            self._field(field, msg[name])
        if not fields and self._aligned:
            self._pack("B", 0)  # no structure of CDR is empty

    def _field(self, field: RosField, value: Any) -> None:
        if field.length is None:
            self._one(field.type, value)
            return
        if field.length == 0:
            self._pack("I", len(value))
        if isinstance(value, np.ndarray) and value.dtype in (np.int8, np.uint8):
            self.data += value.tobytes()
            return
        for item in value:
            self._one(field.type, item)

    def _one(self, type_: str, value: Any) -> None:
        if type_ == "string":
            text = value.encode() + (b"\x00" if self._aligned else b"")
            self._pack("I", len(text))
            self.data += text
        elif type_ == "time":
            self._pack("I", value["secs"])
            self._pack("I", value["nsecs"])
        elif type_ in _FORMATS:
            self._pack(_FORMATS[type_], value)
        else:
            self.message(self._dialect.fields(type_) or {}, value)

    def _pack(self, format_: str, value: Any) -> None:
        if self._aligned:
            self.data += bytes(-len(self.data) % struct.calcsize(f"<{format_}"))
        self.data += struct.pack(f"<{format_}", value)
