"""Messages with one field changed."""

import json
from typing import Any


def changed(msg: dict[str, Any], path: str, value: object) -> dict[str, Any]:
    """A copy with another value at a path of names with dots; `...` leaves the field out."""
    copy: dict[str, Any] = json.loads(json.dumps(msg))
    *way, last = path.split(".")
    inner = copy
    for name in way:
        inner = inner[name]
    if value is ...:
        del inner[last]
    else:
        inner[last] = value
    return copy
