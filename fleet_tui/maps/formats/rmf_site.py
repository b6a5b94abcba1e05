"""Sites of Open-RMF's site editor, to be read: JSON, metres; lanes and locations at anchors of levels."""

from collections.abc import Iterator
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices
from fleet_tui.maps.formats.purposes import Purpose
from fleet_tui.maps.formats.rmf import TYPES, UNNAMED
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
)
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_EDGES, MOST_VERTICES

_TAGS = {"Charger": Purpose.CHARGER, "ParkingSpot": Purpose.PARKING, "HoldingPoint": Purpose.HOLDING}
OTHERS = ("walls", "doors", "floors", "drawings", "lights", "physical_cameras", "measurements")
Anchors = dict[str, tuple[str, float, float]]
"""The level and the place of each anchor."""


def is_site(tree: Table) -> bool:
    """Tell whether a file is one of the site editor: other formats with levels have no version."""
    return "format_version" in tree and isinstance(tree.get("levels"), dict)


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file, with the lanes of all its graphs. Raises GraphError."""
    table = fields.mapping(tree, "file")
    levels = fields.optional_mapping(table.get("levels"), "levels")
    names = {key: _name(fields.mapping(level, f"level {key[:40]}"), key) for key, level in levels.items()}
    if len(set(names.values())) < len(names):
        raise GraphError(Message("two levels have one name: rename one"))
    anchors: Anchors = {}
    for key, level in levels.items():
        anchors |= _anchors(fields.mapping(level, f"level {key[:40]}"), names[key])
    guided = fields.optional_mapping(_at(table, "navigation", "guided"), "navigation guided")
    locations: dict[str, Table] = {}
    for one in _entries(guided, "locations", MOST_VERTICES):
        locations.setdefault(str(one.get("anchor")), one)
    lanes = list(_entries(guided, "lanes", MOST_EDGES))
    edges = list(_edges(lanes, anchors))
    used = dict.fromkeys([*locations, *(end for _, edge in edges for end in (edge.start, edge.end))])
    floors = {}
    for name in names.values():
        here = {id_: anchors[id_][1:] for id_ in used if id_ in anchors and anchors[id_][0] == name}
        vertices = {id_: _vertex(id_, *place, locations.get(id_, {})) for id_, place in here.items()}
        lanes_here = {edge.id: edge for level, edge in edges if level == name}
        floors[name] = DocumentFloor(name, vertices, lanes_here)
    left_out = {key: sum(_count(level.get(key)) for level in levels.values()) for key in OTHERS}
    left_out["lifts"] = _count(table.get("lifts"))
    left_out["lanes between levels or to unknown anchors"] = len(lanes) - len(edges)
    document = GraphDocument(_name(table, ""), floors)
    return GraphFile(
        GraphFormat.RMF_SITE, document, (), {what: count for what, count in left_out.items() if count}
    )


def _at(table: Table, *keys: str) -> Any:
    value: Any = table
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _count(value: Any) -> int:
    return len(value) if isinstance(value, dict | list) else 0


def _name(table: Table, otherwise: str) -> str:
    name = _at(table, "properties", "name")
    return fields.text(name, "name") if name else otherwise


def _entries(table: Table, key: str, most: int) -> Iterator[Table]:
    """Yield the values of a table, each with its id."""
    found = fields.optional_mapping(table.get(key), key)
    fields.elements(list(found), key, most)
    for id_, value in found.items():
        yield {**fields.mapping(value, f"{key} {id_[:40]}"), "id": id_}


def _anchors(level: Table, name: str) -> Anchors:
    found = fields.optional_mapping(level.get("anchors"), f"level {name[:40]} anchors")
    fields.vertex_elements(list(found), f"level {name[:40]} anchors")
    places: Anchors = {}
    for id_, value in found.items():
        where = f"level {name[:40]} anchor {id_[:40]}"
        parts = _at(fields.mapping(value, where), "Translate2D")
        if isinstance(parts, list) and len(parts) == 2:
            places[id_] = name, fields.number(parts[0], where), fields.number(parts[1], where)
    return places


def _vertex(id_: str, x: float, y: float, location: Table) -> DocumentVertex:
    where = f"location {str(location.get('id', ''))[:40]}"
    name = fields.optional(location, "name", fields.text, where) or ""
    tags = fields.elements(location.get("tags"), f"{where} tags", 100)
    type_ = next((TYPES[purpose] for tag, purpose in _TAGS.items() if tag in tags), "")
    return DocumentVertex(id_, x, y, "" if name == UNNAMED else name, type_)


def _edges(lanes: list[Table], anchors: Anchors) -> Iterator[tuple[str, DocumentEdge]]:
    """Yield each lane with its level; both ways unless its way back is disabled."""
    for lane in lanes:
        where = f"lane {lane['id'][:40]}"
        parts = fields.elements(lane.get("anchors"), f"{where} anchors", 2)
        start, end = [*(fields.text(one, f"{where} anchors") for one in parts), "", ""][:2]
        places = [anchors[one] for one in (start, end) if one in anchors]
        if len(places) != 2 or places[0][0] != places[1][0]:
            continue
        speed = _at(lane, "forward", "speed_limit")
        yield (
            places[0][0],
            DocumentEdge(
                lane["id"],
                start,
                end,
                two_way=lane.get("reverse") != "Disable",
                speed=None if speed is None else fields.number(speed, f"{where} speed_limit"),
            ),
        )
