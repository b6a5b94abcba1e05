"""CBOR as bridges write it: maps with names, lists, numbers, texts, bytes and tagged arrays."""

from typing import Any

import cbor2

# All that cbor2 makes more of. With references to what came before, 200 bytes take hours to hash or to
# write out; a number may have more digits than Python writes.
_LIVELY = (0, 1, 2, 3, 4, 5, 25, 28, 29, 30, 35, 36, 37, 52, 54, 100, 256, 258, 260, 261, 1004, 43000)


def _refuse(*_: object) -> None:
    raise ValueError("no bridge sends that")


_DECODERS: Any = dict.fromkeys(_LIVELY, _refuse)


def read_cbor(payload: bytes) -> Any:
    """What it says. Raises ValueError for what is no CBOR, or more than a bridge has to say."""
    try:
        return cbor2.loads(payload, strict_hashable_types=True, semantic_decoders=_DECODERS)
    except (cbor2.CBORDecodeError, RecursionError, OverflowError) as problem:
        raise ValueError(str(problem)) from None
