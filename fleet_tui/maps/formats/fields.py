"""Reads the values of graph files: each error names the place in the file."""

import re
from collections.abc import Callable
from typing import Any, TypeVar

from fleet_tui.maps.formats.yaml_text import PlainText, settled
from fleet_tui.model.graphs.document import Site
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import LONGEST_NAME, MOST_EDGES, MOST_VERTICES, truncate

LONGEST_TEXT = 5 * LONGEST_NAME
"""Maximum characters of an id or a name; longer ones are no names."""
MOST_FLOORS = 500
_NUMBER = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?")
"""As JSON has them, and yaml-cpp, with which map_server reads: no `0x`, no `1_000`, no `1:30`."""
Found = TypeVar("Found")
Table = dict[str, Any]


def _is_no(value: Any, expected: str, where: str) -> GraphError:
    found = settled(value)
    shown = {dict: "a mapping", list: "a list", type(None): "nothing"}.get(type(found))
    return GraphError(
        Message(
            "{where}: {shown} instead of {expected}",
            where=where,
            shown=shown or truncate(repr(found), 40),
            expected=expected,
        )
    )


def mapping(value: Any, where: str) -> Table:
    """Return a mapping. Raises GraphError."""
    if not isinstance(value, dict):
        raise _is_no(value, "a mapping", where)
    return value


def optional_mapping(value: Any, where: str) -> Table:
    """Return a mapping, empty for a missing one. Raises GraphError."""
    return {} if value is None or value == "" else mapping(value, where)


def elements(value: Any, where: str, most: int) -> list[Any]:
    """Return a list, empty for a missing one. Raises GraphError for another value or too many."""
    if value is None or (isinstance(value, PlainText) and not value):
        return []
    if not isinstance(value, list):
        raise _is_no(value, "a list", where)
    if len(value) > most:
        raise GraphError(
            Message(
                "{where}: {count} elements, at most {most} are supported",
                where=where,
                count=f"{len(value):,}",
                most=f"{most:,}",
            )
        )
    return value


def vertex_elements(value: Any, where: str) -> list[Any]:
    """Return a list of vertices."""
    return elements(value, where, MOST_VERTICES)


def edge_elements(value: Any, where: str) -> list[Any]:
    """Return a list of edges, each in one direction."""
    return elements(value, where, 2 * MOST_EDGES)


def text(value: Any, where: str) -> str:
    """Return a name as it is written; a number is one, too, and tables write the whole ones as `1.0`. Raises
    GraphError."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if isinstance(value, int) and not isinstance(value, bool):
        value = str(value)
    if not isinstance(value, str):
        raise _is_no(value, "text", where)
    if len(value) > LONGEST_TEXT:
        raise GraphError(
            Message(
                "{where}: a text of {count} characters, at most {most}",
                where=where,
                count=f"{len(value):,}",
                most=f"{LONGEST_TEXT:,}",
            )
        )
    return str(value)


def identifier(value: Any, where: str) -> str:
    """Return an id. Raises GraphError."""
    id_ = text(value, where)
    if not id_:
        raise GraphError(Message("{where}: empty id", where=where))
    return id_


def is_number(value: str) -> bool:
    """Tell whether a text is a number."""
    return _NUMBER.fullmatch(value.strip()) is not None


def number(value: Any, where: str) -> float:
    """Return a number, finite or not, which some programs write as text. Raises GraphError."""
    found = settled(value)
    if isinstance(found, str) and is_number(found):
        found = float(found)
    if isinstance(found, bool) or not isinstance(found, int | float):
        raise _is_no(value, "a number", where)
    try:
        return float(found)
    except OverflowError:
        raise GraphError(
            Message("{where}: a number of {count} digits", where=where, count=f"{len(str(value)):,}")
        ) from None


def index(value: Any, size: int, where: str) -> int:
    """Return the number of an element in a list of that size, from 0 on. Raises GraphError."""
    found = settled(value)
    if isinstance(found, bool) or not isinstance(found, int):
        raise _is_no(value, "a whole number", where)
    if not 0 <= found < size:
        raise GraphError(
            Message(
                "{where}: unknown vertex {vertex}, the last one is {size}",
                where=where,
                vertex=truncate(str(found), 40),
                size=size - 1,
            )
        )
    return found


def flag(value: Any, where: str) -> bool:
    """Return true or false. Raises GraphError: numbers are neither."""
    found = settled(value)
    if not isinstance(found, bool):
        raise _is_no(value, "true or false", where)
    return found


def place(value: Any, where: str) -> Site:
    """Return x, y and yaw. Raises GraphError."""
    parts = [number(one, where) for one in elements(value, where, 3)]
    if len(parts) != 3:
        raise GraphError(Message("{where}: must be [x, y, yaw]", where=where))
    return parts[0], parts[1], parts[2]


def optional(table: Table, key: str, read: Callable[[Any, str], Found], where: str) -> Found | None:
    """Take a value out of a table; None for a missing one, and for a blank text where a number belongs."""
    value = table.pop(key, None)
    found = settled(value)
    is_blank = read is number and isinstance(found, str) and not found.strip()
    return None if found is None or is_blank else read(value, f"{where} {key}")


def required(table: Table, key: str, read: Callable[[Any, str], Found], where: str) -> Found:
    """Take a value out of a table. Raises GraphError for a missing one."""
    if key not in table:
        raise GraphError(Message("{where}: no {key}", where=where, key=key))
    return read(table.pop(key), f"{where} {key}")


def rest(format_: str, table: Table) -> dict[str, Any]:
    """Return what remains of a table as the `extra` of a format."""
    return {format_: settled(table)} if table else {}
