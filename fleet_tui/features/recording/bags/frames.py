"""A message of a bag as the frame that rosbridge would have sent."""

import base64
import keyword
from collections.abc import Callable
from typing import Any

import cbor2
import msgspec

from fleet_tui.features.recording.bags.definitions import BUILT_IN, TIMES
from fleet_tui.robots.ros.cbor import INT8_ARRAY

Spell = Callable[[Any], Any]

_encode = msgspec.json.Encoder().encode
_KEPT_EMPTY = "structure_needs_at_least_one_member"


class Framer:
    """Writes the messages of one connection. Maps as CBOR, others as JSON: NaN and infinities become null
    there, bytes base64."""

    def __init__(self, store: Any, kind: str, topic: str, is_ros1: bool, as_cbor: bool) -> None:
        self.topic = topic
        self.is_binary = as_cbor
        self._kind = kind
        self._deserialize = store.deserialize_ros1 if is_ros1 else store.deserialize_cdr
        self._spell = _message(store, kind, is_ros1, as_cbor)

    def frame(self, raw: bytes) -> bytes:
        """Return the frame of a message. Unreadable ones raise all kinds of errors."""
        msg = self._spell(self._deserialize(raw, self._kind))
        frame = {"op": "publish", "topic": self.topic, "msg": msg}
        return cbor2.dumps(frame) if self.is_binary else _encode(frame)


def _message(store: Any, kind: str, is_ros1: bool, as_cbor: bool) -> Spell:
    if kind in TIMES and is_ros1:
        # A time of ROS 1 is unsigned, rosbags reads it as signed: it would end in 2038.
        mask = 2**32 - 1 if kind == BUILT_IN["time"] else -1
        return lambda time: {"secs": time.sec & mask, "nsecs": time.nanosec}
    fields = [
        # rosbags renames Python keywords, the wire does not.
        (name, name + "_" * keyword.iskeyword(name), _field(store, desc, is_ros1, as_cbor))
        for name, desc in store.fielddefs[kind][1]
        if name != _KEPT_EMPTY
    ]

    def spell(message: Any) -> dict[str, Any]:
        return {name: write(getattr(message, attribute)) for name, attribute, write in fields}

    return spell


def _same(value: Any) -> Any:
    return value


def _field(store: Any, desc: Any, is_ros1: bool, as_cbor: bool) -> Spell:
    from rosbags.interfaces import Nodetype

    kind, what = desc
    if kind == Nodetype.BASE:
        return _same
    if kind == Nodetype.NAME:
        return _message(store, what, is_ros1, as_cbor)
    (inner_kind, inner), _ = what
    if inner_kind == Nodetype.NAME:
        write = _message(store, inner, is_ros1, as_cbor)
        return lambda values: [write(value) for value in values]
    return _array(inner[0], as_cbor)


def _array(of: str, as_cbor: bool) -> Spell:
    """Return a list of text or numbers; the latter are numpy's."""
    if of == "string":
        return list
    if of in ("uint8", "char"):
        return _bytes if as_cbor else lambda array: base64.b64encode(_bytes(array)).decode()
    if of == "int8" and as_cbor:
        return lambda array: cbor2.CBORTag(INT8_ARRAY, _bytes(array))
    return lambda array: array.tolist()


def _bytes(array: Any) -> bytes:
    content: bytes = array.tobytes()
    return content
