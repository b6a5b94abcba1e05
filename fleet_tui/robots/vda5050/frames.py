"""Messages of a broker as frames of a recording: their topic in the first line, then the payload."""

from typing import NamedTuple

import msgspec

from fleet_tui.text.errors import WireError


class BrokerMessage(NamedTuple):
    """A message with its topic; `kept`: the broker had kept it from before the subscription."""

    topic: str
    payload: bytes
    kept: bool = False


class _Head(msgspec.Struct, omit_defaults=True):
    topic: str
    kept: bool = False


_decoder = msgspec.json.Decoder(_Head)


def frame_of(message: BrokerMessage) -> tuple[bytes, bool]:
    """Return the frame of a message, and whether it is binary: its payload is no text."""
    head = msgspec.json.encode(_Head(message.topic, message.kept))
    try:
        message.payload.decode()
    except UnicodeDecodeError:
        return head + b"\n" + message.payload, True
    return head + b"\n" + message.payload, False


def message_of(frame: bytes) -> BrokerMessage:
    """Return the message of a frame. Raises WireError."""
    head, _, payload = frame.partition(b"\n")
    try:
        found = _decoder.decode(head)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
        raise WireError(f"frame of {len(frame):,} bytes without a topic: {problem}") from None
    return BrokerMessage(found.topic, payload, found.kept)
