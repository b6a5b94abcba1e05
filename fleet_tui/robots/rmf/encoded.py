"""Messages that are JSON in a std_msgs/String."""

from collections.abc import Callable, Mapping
from itertools import islice
from typing import Any, TypeVar

import msgspec

from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.navigation import Text
from fleet_tui.text.errors import WireError
from fleet_tui.text.limits import LONGEST_NAME, truncate

S = TypeVar("S", bound=msgspec.Struct)

LEVELS = 8
PARTS = 100
"""Nested lists that are shown, and parts of each: other clients write them."""


def decoder(struct: type[S]) -> Callable[[str], S]:
    """Return a function that reads JSON text. It raises WireError with the field's name."""
    decode = msgspec.json.Decoder(struct).decode

    def read(text: str) -> S:
        try:
            return decode(text)
        except (msgspec.MsgspecError, UnicodeError, RecursionError) as problem:
            raise WireError(str(problem)) from None

    return read


def text_reader(struct: type[S]) -> Callable[[object], S]:
    """Return a function that reads a std_msgs/String with JSON in it. It raises WireError."""
    read, decode = ros.reader(Text), decoder(struct)
    return lambda msg: decode(read(msg).data)


def line_of(value: Any, levels: int = LEVELS) -> str:
    """Return a value of any shape as one line of text, `levels` deep."""
    if not levels:
        text = "..."
    elif isinstance(value, str):
        text = value
    elif isinstance(value, Mapping):
        text = ", ".join(f"{key}: {line_of(part, levels - 1)}" for key, part in islice(value.items(), PARTS))
    elif isinstance(value, list):
        text = ", ".join(line_of(part, levels - 1) for part in value[:PARTS])
    else:
        text = "" if value is None else str(value)
    return truncate(" ".join(text.split()), LONGEST_NAME)
