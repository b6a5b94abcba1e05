"""CBOR as bridges write it: maps with names, lists, numbers, texts, bytes and tagged arrays."""

import re
from typing import Any

import cbor2

LARGEST_REST = 2**20
"""Bytes beside the cells of a map: decoding empty lists takes half a second for each of these."""
INT8_ARRAY = 72

# All further types of cbor2 are rejected. With back references, 200 bytes take hours to hash or to
# write out; a number may have more digits than Python writes.
_LIVELY = (0, 1, 2, 3, 4, 5, 25, 28, 29, 30, 35, 36, 37, 52, 54, 100, 256, 258, 260, 261, 1004, 43000)
# The head of a byte string of more than 64 kB, and its placeholder while the rest is decoded.
_LONG_BYTES = re.compile(rb"\x5a(?=(.{4}))", re.DOTALL)
_STANDS_FOR_IT = b"\x48" + b"longdata"


def _refuse(*_: object) -> None:
    raise ValueError("not sent by any bridge")


_DECODERS: Any = dict.fromkeys(_LIVELY, _refuse)


def read_cbor(payload: bytes) -> Any:
    """Decode CBOR. Raises ValueError for invalid CBOR, or more than a bridge should send."""
    data = b""
    if len(payload) > LARGEST_REST:
        payload, data = _without_cells(payload)
    try:
        frame = cbor2.loads(payload, strict_hashable_types=True, semantic_decoders=_DECODERS)
    except (cbor2.CBORDecodeError, RecursionError, OverflowError) as problem:
        raise ValueError(str(problem)) from None
    return _with_cells(frame, data) if data else frame


def _without_cells(payload: bytes) -> tuple[bytes, bytes]:
    """Return a large message without its one long byte string, and that string."""
    for found in _LONG_BYTES.finditer(payload, 0, 65_536):
        start = found.end() + 4
        end = start + int.from_bytes(found[1], "big")
        if end <= len(payload) <= end - start + LARGEST_REST:
            return payload[: found.start()] + _STANDS_FOR_IT + payload[end:], payload[start:end]
    raise ValueError(f"more than {LARGEST_REST:,} bytes beside the cells of a map")


def _with_cells(frame: Any, data: bytes) -> Any:
    msg = frame.get("msg") if isinstance(frame, dict) else None
    if isinstance(msg, dict) and msg.get("data") == cbor2.CBORTag(INT8_ARRAY, _STANDS_FOR_IT[1:]):
        msg["data"] = cbor2.CBORTag(INT8_ARRAY, data)
    elif isinstance(msg, dict) and msg.get("data") == _STANDS_FOR_IT[1:]:  # a picture
        msg["data"] = data
    return frame
