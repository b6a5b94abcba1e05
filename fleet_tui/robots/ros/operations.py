"""Operations of the rosbridge v2 protocol, to and from frames.

Based on transcripts of a real rosbridge_server 0.11: see tests/wire.
"""

import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import msgspec

from fleet_tui.robots.ros.cbor import read_cbor
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import in_english


class Publish(msgspec.Struct, frozen=True):
    """A message of a topic. `msg` is still encoded: JSON, or an object decoded from CBOR."""

    topic: str
    msg: Any


class ServiceResponse(msgspec.Struct, frozen=True):
    """The answer to a call. With `result` False the values are a string with the reason."""

    id: str
    values: Any
    result: bool


class GoalResult(msgspec.Struct, frozen=True):
    """The end of a goal of ours. With `result` False the values are a string with the reason of its
    rejection."""

    id: str
    values: Any
    status: int
    result: bool


class Status(msgspec.Struct, frozen=True):
    """A status message of the bridge about one of our operations."""

    level: str
    text: str


class Fragment(msgspec.Struct, frozen=True):
    """Fragment `num` (from 0) of `total` of a message; `id` identifies the message."""

    id: str
    data: str
    num: int
    total: int


LARGEST_ANSWER = 4 * 2**20
"""Maximum bytes of the values of an answer, or of a bridge's status; larger ones are not read."""

Operation = Publish | ServiceResponse | GoalResult | Status | Fragment


class _Frame(msgspec.Struct):
    """The union of every operation's fields, so that one pass reads any of them."""

    op: str
    topic: str = ""
    msg: msgspec.Raw = msgspec.Raw(b"null")
    id: str | None = None
    values: msgspec.Raw = msgspec.Raw(b"null")
    result: bool = True
    status: int = 0
    level: str = ""
    data: str = ""
    num: int = -1
    total: int = 0


_decoder = msgspec.json.Decoder(_Frame)
_encoder = msgspec.json.Encoder(enc_hook=in_english)


def _values(raw: msgspec.Raw) -> Any:
    size = memoryview(raw).nbytes
    return msgspec.json.decode(raw) if size <= LARGEST_ANSWER else f"{size:,} bytes, too large to read"


def decode(payload: bytes) -> Operation | None:
    """Decode a text frame into an operation, None for one that a client ignores.

    Raises WireError for an invalid frame.
    """
    try:
        return _decode_strictly(payload)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
        reason = problem
    if len(payload) <= LARGEST_LENIENT:
        for without in (_without_bare, _without_spaced):
            with suppress(msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
                return _decode_strictly(without(payload))
    raise WireError(f"frame of {len(payload):,} bytes: {reason}")


def _decode_strictly(payload: bytes) -> Operation | None:
    frame = _decoder.decode(payload)
    match frame.op:
        case "publish":
            return Publish(frame.topic, frame.msg)
        case "service_response":
            return ServiceResponse(frame.id or "", _values(frame.values), frame.result)
        case "action_result":
            return GoalResult(frame.id or "", _values(frame.values), frame.status, frame.result)
        case "fragment":
            return Fragment(frame.id or "", frame.data, frame.num, frame.total)
        case "status":
            text = _values(frame.msg)
            return Status(frame.level, text if isinstance(text, str) else str(text))
    return None


LARGEST_LENIENT = 2**20
"""Maximum bytes of a frame that is parsed once more without bare NaN and Infinity."""
_BARE = tuple(
    (before + word, before + b"null")
    for word in (b"NaN", b"Infinity", b"-Infinity")
    for before in (b",", b"[", b":")
)
_SPACED = re.compile(rb"(?<=[\[,:])\s*(?:NaN|-?Infinity)\b")


def _without_bare(payload: bytes) -> bytes:
    """Replace NaN and Infinity by null: a bridge of ROS 2 writes them bare in arrays of fixed length, such as
    every covariance, which is invalid JSON, and as null elsewhere. Ten times as fast as the expression."""
    for word, null in _BARE:
        payload = payload.replace(word, null)
    return payload


def _without_spaced(payload: bytes) -> bytes:
    """Replace them if they follow spaces."""
    return _SPACED.sub(b"null", payload)


def decode_cbor(payload: bytes) -> Operation | None:
    """Decode a binary frame into an operation, like `decode`. Only topics use CBOR."""
    try:
        frame = read_cbor(payload)
    except ValueError as problem:
        raise WireError(f"binary frame of {len(payload):,} bytes: {problem}") from None
    if not isinstance(frame, dict) or not isinstance(frame.get("topic"), str):
        raise WireError(f"binary frame of {len(payload):,} bytes is not a publish operation")
    return Publish(frame["topic"], frame.get("msg")) if frame.get("op") == "publish" else None


@dataclass(frozen=True, slots=True)
class Subscription:
    """A subscription to one topic. Rates are in milliseconds, 0 is every message; the queue length is at
    least one on ROS 1, or one slow client would block the topic for all. `latched`: with the QoS that gets
    the last value as soon as its publisher is discovered, unknown to ROS 1."""

    topic: str
    type: str
    throttle_rate: int = 0
    compression: str = "none"
    queue_length: int = 1
    latched: bool = False


LATCHED = {"durability": "transient_local", "reliability": "reliable", "history": "keep_last", "depth": 1}


def subscribe(wanted: Subscription) -> bytes:
    """Return the frame that subscribes to a topic."""
    operation: dict[str, object] = {
        "op": "subscribe",
        "id": f"subscribe:{wanted.topic}",
        "topic": wanted.topic,
        "type": wanted.type,
        "throttle_rate": wanted.throttle_rate,
        "queue_length": wanted.queue_length,
        "compression": wanted.compression,
    }
    # Of several publishers, or of one that keeps several messages, all are delivered at once.
    qos = {**LATCHED, "depth": wanted.queue_length}
    return _encoder.encode(operation | {"qos": qos} if wanted.latched else operation)


def unsubscribe(topic: str) -> bytes:
    return _encoder.encode({"op": "unsubscribe", "id": f"subscribe:{topic}", "topic": topic})


def call_service(call_id: str, service: str, args: Mapping[str, object], timeout: float | str) -> bytes:
    """Return the frame that calls a service. `args` must be complete: a bridge fills gaps with zeros. A
    bridge of ROS 2 gives a call up after `timeout` seconds, and declines one that is text; that of ROS 1
    ignores it."""
    return _encoder.encode(
        {"op": "call_service", "id": call_id, "service": service, "args": args, "timeout": timeout}
    )


def send_action_goal(goal_id: str, action: str, type_: str, args: Mapping[str, object]) -> bytes:
    """Return the frame that gives a goal, without feedback: its topic has that of all clients."""
    goal = {"id": goal_id, "action": action, "action_type": type_, "feedback": False, "args": args}
    return _encoder.encode({"op": "send_action_goal", **goal})


def advertise(topic: str, type_: str) -> bytes:
    """Return the frame that advertises a topic: subscribers connect late to a new publisher, and the first
    message may be lost."""
    return _encoder.encode({"op": "advertise", "id": f"advertise:{topic}", "topic": topic, "type": type_})


def advertise_newest(topic: str, type_: str) -> bytes:
    """Return the frame that advertises a topic of which the bridge keeps the newest message alone."""
    wanted = {"topic": topic, "type": type_, "queue_size": 1}
    return _encoder.encode({"op": "advertise", "id": f"advertise:{topic}", **wanted})


def publish(topic: str, type_: str, message: Mapping[str, object]) -> bytes:
    """Return the frame that publishes a message. With its type a bridge needs no advertisement."""
    return _encoder.encode({"op": "publish", "topic": topic, "type": type_, "msg": message})


_PNG = re.compile(rb'\s*\{\s*"op"\s*:\s*"png"')


def is_png(payload: bytes) -> bool:
    """Tell without decoding it whether a text frame is another one, compressed as PNG."""
    return _PNG.match(payload) is not None


def png_of(payload: bytes) -> str:
    """Return the picture of such a frame, in base64. Raises WireError."""
    try:
        return _decoder.decode(payload).data
    except msgspec.MsgspecError as problem:
        raise WireError(f"frame of {len(payload):,} bytes: {problem}") from None


_TOPIC = re.compile(rb'"topic"\s*:\s*("(?:[^"\\]|\\.){1,200}")')


def topic_of(payload: bytes) -> str:
    """Return the topic of a publish frame without decoding it, "" if it isn't near the start."""
    found = _TOPIC.search(payload, 0, 1000)
    try:
        return str(msgspec.json.decode(found.group(1))) if found else ""
    except msgspec.DecodeError:
        return ""
