"""Messages in pieces: `op: fragment`, in both directions."""

import json
from collections.abc import Iterator
from typing import Any

from fleet_tui.simulator.frames import to_json

UNFINISHED = 100  # messages of one client that may be incomplete at a time

_RESPONSE = '{"op":"service_response"'


def split(text: str, size: int, default_id: int | str) -> Iterator[str]:
    """Split a text into frames of at most `size` characters each; a shorter one is returned whole. A fragment
    has the id of the message, if it has one."""
    if len(text) <= size:
        yield text
        return
    own = json.loads(text).get("id") if text.startswith(_RESPONSE) else None
    id_ = default_id if own is None else own
    total = -(-len(text) // size)
    for number in range(total):
        data = text[number * size : (number + 1) * size]
        yield to_json({"op": "fragment", "id": id_, "data": data, "num": number, "total": total})


class Assembler:
    """Reassembles a client's fragments."""

    def __init__(self) -> None:
        self._parts: dict[object, dict[int, str]] = {}

    def add(self, fragment: dict[str, Any]) -> str | None:
        """Take a fragment; the whole text with the last one."""
        id_, number, total = fragment["id"], fragment["num"], fragment["total"]
        if not 0 <= number < total:
            return None
        parts = self._parts.setdefault(id_, {})
        parts[number] = fragment["data"]
        if len(parts) < total:
            if len(self._parts) > UNFINISHED:
                del self._parts[next(iter(self._parts))]
            return None
        del self._parts[id_]
        return "".join(parts[i] for i in sorted(parts))
