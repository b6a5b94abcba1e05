"""Writes the program's own format: values at their defaults are left out."""

from collections.abc import Iterator, Mapping
from enum import Enum
from functools import cache
from typing import Any

from msgspec import Struct
from msgspec.structs import fields as fields_of

from fleet_tui.maps.formats.graph_file import WriteChoices
from fleet_tui.maps.formats.native import MARK, OWN
from fleet_tui.maps.formats.yaml_text import flow, key_text
from fleet_tui.model.graphs.document import VERSION, DocumentFloor, GraphDocument

Table = dict[str, Any]
_EMPTY: tuple[object, ...] = ("", None, (), {})


def write(document: GraphDocument, choices: WriteChoices) -> str:
    return "\n".join([*_lines(document), ""])


def _lines(document: GraphDocument) -> Iterator[str]:
    own, more = _split(document.extra)
    yield f"{MARK}: {VERSION}"
    yield f"name: {flow(document.name)}"
    yield "floors:" if document.floors else "floors: {}"
    for floor in document.floors.values():
        yield f"  {key_text(floor.name)}:"
        yield from (f"    {line}" for line in _floor_lines(floor))
    for kind, parts in (("lifts", document.lifts), ("stations", document.stations)):
        if parts:
            yield f"{kind}:"
            yield from (f"  - {flow(_set(part))}" for part in parts)
    if more:
        yield f"extra: {flow(more)}"
    yield from (f"{key_text(key)}: {flow(value)}" for key, value in own.items())


def _floor_lines(floor: DocumentFloor) -> Iterator[str]:
    for key, value in _set(floor, "name", "vertices", "edges").items():
        yield f"{key_text(key)}: {flow(value)}"
    for kind, parts in (("vertices", floor.vertices), ("edges", floor.edges)):
        yield f"{kind}:" if parts else f"{kind}: []"
        yield from (f"  - {flow(_set(part))}" for part in parts.values())


def _split(extra: Mapping[str, Any]) -> tuple[Table, Table]:
    """Return the format's own unknown keys, and the extra of other formats."""
    return dict(extra.get(OWN, {})), {key: value for key, value in extra.items() if key != OWN}


def _set(part: Struct, *without: str) -> Table:
    """Return the values that differ from their defaults; those without a default always."""
    found: Table = {}
    for name, required, default in _fields(type(part)):
        if name in without or name == "extra":
            continue
        value = getattr(part, name)
        if required or not (value in _EMPTY or value == default):
            found[name] = _plain(value)
    own, more = _split(getattr(part, "extra", {}))
    return {**found, **({"extra": more} if more else {}), **own}


@cache
def _fields(kind: type[Struct]) -> list[tuple[str, bool, Any]]:
    """Return name, whether it is required, and the default of each field."""
    return [(one.name, one.required, one.default) for one in fields_of(kind)]


def _plain(value: Any) -> Any:
    if isinstance(value, Enum):
        return value.value
    return _set(value) if isinstance(value, Struct) else value
