"""Reads the program's own format: all of a document as YAML, a vertex or an edge in a line."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices
from fleet_tui.maps.formats.yaml_text import settled
from fleet_tui.model.graphs.document import (
    VERSION,
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    MapReference,
    Motion,
    Polyline,
    Station,
    Stop,
)
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message

MARK = "fleet_tui_graph"
"""The key by which such a file is recognised; its value is the version."""
OWN = GraphFormat.NATIVE.value
Readers = Mapping[str, Callable[[Any, str], Any]]


def _motion(value: Any, where: str) -> Motion:
    word = fields.text(value, where)
    if word not in (one.value for one in Motion):
        raise GraphError(
            Message("{where}: {word} is none of any, forward, backward", where=where, word=f"{word[:40]!r}")
        )
    return Motion(word)


def _points(value: Any, where: str) -> Polyline:
    return tuple(_pair(point, where) for point in fields.elements(value, where, 1000))


def _pair(value: Any, where: str) -> tuple[float, float]:
    parts = [fields.number(one, where) for one in fields.elements(value, where, 2)]
    if len(parts) != 2:
        raise GraphError(Message("{where}: must be two numbers", where=where))
    return parts[0], parts[1]


def _stops(value: Any, where: str) -> tuple[Stop, ...]:
    found = []
    for stop in fields.elements(value, where, 20_000):
        parts = [fields.text(one, where) for one in fields.elements(stop, where, 2)]
        if len(parts) != 2:
            raise GraphError(Message("{where}: a stop must be [floor, vertex]", where=where))
        found.append((parts[0], parts[1]))
    return tuple(found)


def _map(value: Any, where: str) -> MapReference:
    readers: Readers = {"resolution": fields.number, "origin": fields.place}
    table = dict(fields.mapping(value, where))
    file = fields.required(table, "file", fields.text, where)
    return MapReference(file, **_known(table, readers, where))


def _values(value: Any, where: str) -> Table:
    return fields.mapping(settled(value), where)


VERTEX: Readers = {
    "label": fields.text,
    "type": fields.text,
    "heading": fields.number,
    "source_id": fields.text,
    "extra": _values,
}
EDGE: Readers = {
    "two_way": fields.flag,
    "reverse_id": fields.text,
    "speed": fields.number,
    "speed_percent": fields.number,
    "cost": fields.number,
    "locked": fields.flag,
    "motion": _motion,
    "length": fields.number,
    "control_points": _points,
    "per_vehicle": _values,
    "source_id": fields.text,
    "extra": _values,
}
FLOOR: Readers = {"frame_id": fields.text, "map": _map, "to_site": fields.place, "extra": _values}
PLACED: Readers = {
    "stops": _stops,
    "x": fields.number,
    "y": fields.number,
    "yaw": fields.number,
    "extra": _values,
}
LIFT: Readers = {**PLACED, "size": _pair}
STATION: Readers = {**PLACED, "height": fields.number}


def _known(table: Table, readers: Readers, where: str) -> Table:
    """Take the known values out of a table."""
    found = {key: fields.optional(table, key, read, where) for key, read in readers.items() if key in table}
    return {key: value for key, value in found.items() if value is not None}


def _with_rest(known: Table, rest: Table) -> Table:
    """Keep unknown keys, of a later version or by hand, as extra."""
    return {**known, "extra": {**known.get("extra", {}), **fields.rest(OWN, rest)}} if rest else known


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file. Raises GraphError."""
    table = dict(fields.mapping(tree, "file"))
    version = fields.required(table, MARK, fields.number, "file")
    if version != VERSION:
        raise GraphError(
            Message(
                "version {version} of the format: this program reads {own_version}; update it",
                version=f"{version:g}",
                own_version=VERSION,
            )
        )
    name = fields.optional(table, "name", fields.text, "file") or ""
    floors = fields.optional_mapping(table.pop("floors", None), "floors")
    if len(floors) > fields.MOST_FLOORS:
        raise GraphError(
            Message(
                "floors: {floors}, at most {most_floors}",
                floors=f"{len(floors):,}",
                most_floors=fields.MOST_FLOORS,
            )
        )
    lifts = _placed(table.pop("lifts", None), LIFT, "lift")
    stations = _placed(table.pop("stations", None), STATION, "station")
    extra = _with_rest(_known(table, {"extra": _values}, "file"), table).get("extra", {})
    document = GraphDocument(
        name,
        {name: _floor(name, floor) for name, floor in floors.items()},
        tuple(Lift(**one) for one in lifts),
        tuple(Station(**one) for one in stations),
        extra=extra,
    )
    return GraphFile(GraphFormat.NATIVE, document)


def _placed(value: Any, readers: Readers, kind: str) -> Iterator[Table]:
    for n, one in enumerate(fields.elements(value, f"{kind}s", 10_000)):
        table = dict(fields.mapping(one, f"{kind} {n}"))
        name = fields.required(table, "name", fields.text, f"{kind} {n}")
        yield {"name": name, **_with_rest(_known(table, readers, f"{kind} {name[:40]}"), table)}


def _floor(name: str, value: Any) -> DocumentFloor:
    where = f"floor {name[:40]}"
    table = dict(fields.mapping(value, where))
    vertices = _vertices(fields.vertex_elements(table.pop("vertices", None), f"{where} vertices"), where)
    edges = _edges(fields.edge_elements(table.pop("edges", None), f"{where} edges"), where)
    known = _with_rest(_known(table, FLOOR, where), table)
    return DocumentFloor(name, {one.id: one for one in vertices}, {one.id: one for one in edges}, **known)


def _named(parts: list[Any], kind: str, where: str) -> Iterator[tuple[str, tuple[str, ...], Table]]:
    """Yield each element with its distinct id and the id of the file that it repeats."""
    tables = [dict(fields.mapping(part, f"{where} {kind}[{n}]")) for n, part in enumerate(parts)]
    ids = [
        fields.required(table, "id", fields.identifier, f"{where} {kind}[{n}]")
        for n, table in enumerate(tables)
    ]
    for (id_, repeats), table in zip(distinct(ids), tables, strict=True):
        yield id_, repeats, table


def _vertices(parts: list[Any], where: str) -> Iterator[DocumentVertex]:
    for id_, repeats, table in _named(parts, "vertices", where):
        at = f"{where} vertex {(*repeats, id_)[0]}"
        x, y = (fields.required(table, axis, fields.number, at) for axis in ("x", "y"))
        known = _with_rest(_known(table, VERTEX, at), table)
        yield DocumentVertex(id_, x, y, repeats=repeats, **known)


def _edges(parts: list[Any], where: str) -> Iterator[DocumentEdge]:
    for id_, repeats, table in _named(parts, "edges", where):
        at = f"{where} edge {(*repeats, id_)[0]}"
        start, end = (fields.required(table, key, fields.identifier, at) for key in ("start", "end"))
        known = _with_rest(_known(table, EDGE, at), table)
        yield DocumentEdge(id_, start, end, repeats=repeats, **known)
