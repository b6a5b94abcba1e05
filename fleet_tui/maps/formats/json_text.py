"""JSON of graph files: errors with their line, texts that every reader can take."""

import json
import re
from typing import Any

import msgspec

from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message, in_english
from fleet_tui.text.limits import truncate

_UNSAFE = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff]")


def parse_json(text: str) -> Any:
    """Return the value of a file. Raises GraphError."""
    try:
        return msgspec.json.decode(text)
    except RecursionError:
        raise GraphError(Message("nested too deep")) from None
    except (msgspec.DecodeError, ValueError) as problem:
        raise GraphError(Message("not JSON: {problem}", problem=in_line(str(problem), text))) from None


def in_line(problem: str, text: str) -> str:
    """Name the line instead of the byte."""
    found = re.search(r"\(byte (\d+)\)", problem)
    if found is None:
        return truncate(problem, 200)
    line = text.encode()[: int(found.group(1))].count(b"\n") + 1
    return f"{problem[: found.start()]}in line {line}".removeprefix("JSON is malformed: ")


def quoted(text: str) -> str:
    """Return a text in quotes, valid in JSON and in YAML."""
    return _UNSAFE.sub(lambda found: f"\\u{ord(found.group()):04x}", json.dumps(text, ensure_ascii=False))


def to_json(value: Any) -> str:
    """Return a value as indented JSON: floats with a point, as some readers tell the types by it."""
    return msgspec.json.format(encoded(value), indent=2).decode() + "\n"


def encoded(value: Any) -> bytes:
    """Return a value as JSON. Raises GraphError for a number that other readers could not take."""
    try:
        return msgspec.json.encode(value, enc_hook=in_english)
    except OverflowError:
        raise GraphError(Message("a whole number of more than 64 bits: correct it first")) from None
