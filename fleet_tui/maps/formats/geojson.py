"""Route graphs of Nav2's route server: GeoJSON in metres, vertices as Points, one-way edges as lines."""

import math
from collections.abc import Iterable, Iterator
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices, WriteChoices
from fleet_tui.maps.formats.json_text import encoded
from fleet_tui.maps.formats.renumbering import Numbered, numbered
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Motion,
    merge_opposites,
    one_way_edges,
)
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_EDGES, MOST_VERTICES, truncate

OWN = GraphFormat.GEOJSON.value
LINES = ("LineString", "MultiLineString")
FRAME = "map"
_CRS = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}}
SMALLEST_SITE = 1.0
SMALLEST_FLOOR = 0.05
"""Metres; if a file says that it has degrees, and if not."""
_NEAR = 1e-6  # metres between an edge's coordinates and its vertices
_MOTIONS = {motion.value: motion for motion in Motion}


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file. Raises GraphError."""
    table = dict(fields.mapping(tree, "file"))
    table.pop("type", None)
    if table.get("crs") == _CRS:
        table.pop("crs")
    name = fields.optional(table, "name", fields.text, "file") or ""
    parts = fields.elements(table.pop("features", None), "features", MOST_VERTICES + 2 * MOST_EDGES)
    points, lines, others = list[Table](), list[Table](), 0
    for n, part in enumerate(parts):
        feature = dict(fields.mapping(part, f"features[{n}]"))
        mapping_of = fields.optional_mapping if "id" in feature else fields.mapping
        properties = dict(mapping_of(feature.get("properties"), f"features[{n}] properties"))
        if str(feature.get("feature_type")).startswith("rmf_"):
            raise GraphError(
                Message("a building of Open-RMF in degrees: export its navigation graph, in metres")
            )
        geometry = feature["geometry"] = fields.optional_mapping(
            feature.get("geometry"), f"features[{n}] geometry"
        )
        type_ = geometry.get("type", "LineString" if "startid" in properties else None)
        if "id" not in properties and "id" in feature:
            properties["id"] = feature.pop("id")  # as RFC 7946 has it
        feature["properties"] = properties
        (points if type_ == "Point" else lines if type_ in LINES else []).append(feature)
        others += type_ != "Point" and type_ not in LINES
    if len(points) > MOST_VERTICES:
        raise GraphError(
            Message(
                "{points} vertices, at most {most_vertices} are supported",
                points=f"{len(points):,}",
                most_vertices=f"{MOST_VERTICES:,}",
            )
        )
    frames = [point["properties"].get("frame") for point in points]
    frame = next((one for one in frames if isinstance(one, str) and one), "")
    vertices = {vertex.id: vertex for vertex in _vertices(points, frame)}
    _require_metres(table.get("crs"), vertices)
    edges = merge_opposites(_edges(lines, vertices))
    floor = DocumentFloor(choices.floor, vertices, edges, frame)
    document = GraphDocument(name, {floor.name: floor}, extra=fields.rest(OWN, table))
    return GraphFile(GraphFormat.GEOJSON, document, (), {"other features": others} if others else {})


def _require_metres(crs: Any, vertices: dict[str, DocumentVertex]) -> None:
    """Raise GraphError for coordinates that are degrees: the file says so, or all of it would be within some
    centimetres, far from the origin."""
    places = [(vertex.x, vertex.y) for vertex in vertices.values()]
    if len(places) < 2:
        return
    size = max(max(axis) - min(axis) for axis in zip(*places, strict=True))
    says_so = any(name in str(crs) for name in ("CRS84", "EPSG::4326", "EPSG:4326"))
    is_far = any(abs(part) > 1.0 for place in places for part in place)
    if 0 < size < (SMALLEST_SITE if says_so else SMALLEST_FLOOR) and is_far:
        raise GraphError(
            Message(
                "coordinates of degrees, not metres: all within {size}: save them in metres of the map",
                size=f"{size:.2g}",
            )
        )


def _ids(features: list[Table], kind: str, others: Iterable[str] = ()) -> list[tuple[str, tuple[str, ...]]]:
    ids = [
        fields.required(one["properties"], "id", _id, f"{kind} {n} of the file")
        for n, one in enumerate(features)
    ]
    return distinct(ids, others)


def _id(value: Any, where: str) -> str:
    if isinstance(value, float) and value.is_integer():
        value = int(value)  # QGIS writes 1.0
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise GraphError(
            Message(
                "{where}: {given} instead of a whole number from 0 on",
                where=where,
                given=truncate(repr(value), 40),
            )
        )
    return str(value)


def _text(table: Table, key: str) -> str:
    """Take a name out of the metadata, which are free: another value stays there."""
    value = table.get(key)
    if isinstance(value, bool) or not isinstance(value, str | int) or value == "":
        return ""
    return fields.text(table.pop(key), key)


def _vertices(points: list[Table], frame: str) -> Iterator[DocumentVertex]:
    for (id_, repeats), feature in zip(_ids(points, "vertex"), points, strict=True):
        where, properties = f"vertex {(*repeats, id_)[0]}", feature["properties"]
        geometry = dict(feature["geometry"])
        coordinates = fields.elements(geometry.pop("coordinates", None), f"{where} coordinates", 3)
        if len(coordinates) < 2:
            raise GraphError(Message("{where}: coordinates must be [x, y]", where=where))
        x, y = (fields.number(one, f"{where} coordinates") for one in coordinates[:2])
        if len(coordinates) > 2:
            geometry["z"] = coordinates[2]
        if properties.get("frame") == frame:
            properties.pop("frame")
        metadata = _metadata(properties)
        label, type_, source = (_text(metadata, key) for key in ("name", "class", "source_id"))
        extra = _extra(feature, geometry, metadata)
        yield DocumentVertex(id_, x, y, label, type_, source_id=source, extra=extra, repeats=repeats)


def _metadata(properties: Table) -> Table:
    """Return a copy of the metadata; anything but an object stays where it is."""
    found = properties.get("metadata")
    return dict(found) if isinstance(found, dict) else {}


def _extra(feature: Table, geometry: Table, metadata: Table) -> Table:
    """Return the remaining parts of a feature."""
    properties = dict(feature["properties"])
    if isinstance(properties.get("metadata"), dict):
        properties.pop("metadata")
    properties |= {"metadata": metadata} if metadata else {}
    geometry = {key: value for key, value in geometry.items() if (key, value) not in _USUAL}
    left = {key: value for key, value in feature.items() if key not in ("type", "properties", "geometry")}
    left |= {"properties": properties} if properties else {}
    left |= {"geometry": geometry} if geometry else {}
    return fields.rest(OWN, left)


_USUAL = (("type", "Point"), ("type", "LineString"))


def _edges(lines: list[Table], vertices: dict[str, DocumentVertex]) -> Iterator[DocumentEdge]:
    # One counter: an edge that needs another id must not get that of a vertex.
    for (id_, repeats), feature in zip(_ids(lines, "edge", vertices), lines, strict=True):
        where, properties = f"edge {(*repeats, id_)[0]}", feature["properties"]
        start, end = (fields.required(properties, key, _id, where) for key in ("startid", "endid"))
        metadata = _metadata(properties)
        cost = fields.optional(properties, "cost", fields.number, where)
        speed = fields.optional(metadata, "abs_speed_limit", fields.number, where)
        length = fields.optional(metadata, "length", fields.number, where)
        locked = metadata.pop("locked") if isinstance(metadata.get("locked"), bool) else False
        motion = _MOTIONS.get(_text(metadata, "motion"), Motion.ANY)
        geometry = dict(feature["geometry"])
        if _is_straight(geometry.get("coordinates"), vertices.get(start), vertices.get(end)):
            geometry.pop("coordinates", None)
        yield DocumentEdge(
            id_,
            start,
            end,
            two_way=False,
            speed=speed,
            cost=cost,
            locked=locked,
            motion=motion,
            length=length,
            source_id=_text(metadata, "source_id"),
            extra=_extra(feature, geometry, metadata),
            repeats=repeats,
        )


def _is_straight(value: Any, start: DocumentVertex | None, end: DocumentVertex | None) -> bool:
    """Tell whether coordinates are missing, or only those of the vertices."""
    if value == []:
        return True
    if start is None or end is None or not isinstance(value, list):
        return value is None
    points = value[0] if len(value) == 1 and isinstance(value[0], list) else value
    try:
        ends = [math.dist(point[:2], (at.x, at.y)) for point, at in zip(points, (start, end), strict=True)]
    except (TypeError, ValueError, OverflowError):
        return False
    return max(ends) < _NEAR


def new_ids(floor: DocumentFloor) -> Numbered:
    """Return the floor with ids as the route server takes them: one counter for vertices and edges."""
    return numbered(floor, lowest=0, one_counter=True)


def write(document: GraphDocument, choices: WriteChoices) -> str:
    """Return the text of the only floor of a document, a feature in a line."""
    (floor,) = document.floors.values()
    floor = new_ids(floor).floor
    ways = one_way_edges(floor.edges.values(), (*floor.vertices, *floor.edges))
    features = [_point(vertex, floor.frame_id or FRAME) for vertex in floor.vertices.values()]
    features += [_line(edge, floor) for edge in ways]
    top = {"type": "FeatureCollection", "name": document.name or floor.name, "crs": _CRS}
    head = [
        f"  {_json(key)}: {_json(value)}," for key, value in {**top, **document.extra.get(OWN, {})}.items()
    ]
    body = ",\n".join(f"    {_json(feature)}" for feature in features)
    return "\n".join(["{", *head, '  "features": [', body, "  ]", "}", ""])


def _json(value: Any) -> str:
    return encoded(value).decode()


def _feature(own: Table, properties: Table, metadata: Table, geometry: Table) -> Table:
    """Return a feature with its extra parts."""
    more = dict(own.get("properties", {}))
    metadata = {**more.pop("metadata", {}), **metadata} if _has_object(more) else metadata
    properties = {**properties, **more, **({"metadata": metadata} if metadata else {})}
    rest = {key: value for key, value in own.items() if key not in ("properties", "geometry")}
    return {"type": "Feature", "properties": properties, "geometry": geometry, **rest}


def _has_object(properties: Table) -> bool:
    return isinstance(properties.get("metadata", {}), dict)


def _point(vertex: DocumentVertex, frame: str) -> Table:
    own = vertex.extra.get(OWN, {})
    texts = {"name": vertex.label, "class": vertex.type, "source_id": vertex.source_id}
    metadata = {key: value for key, value in texts.items() if value}
    more = dict(own.get("geometry", {}))
    height = [more.pop("z")] if "z" in more else []
    geometry = {"type": "Point", "coordinates": [float(vertex.x), float(vertex.y), *height], **more}
    return _feature(own, {"id": int(vertex.id), "frame": frame}, metadata, geometry)


def _line(edge: DocumentEdge, floor: DocumentFloor) -> Table:
    own = edge.extra.get(OWN, {})
    numbers = {"abs_speed_limit": edge.speed, "length": edge.length}
    metadata: Table = {key: float(value) for key, value in numbers.items() if value is not None}
    metadata |= {"locked": True} if edge.locked else {}
    metadata |= {"motion": edge.motion.value} if edge.motion is not Motion.ANY else {}
    metadata |= {"source_id": edge.source_id} if edge.source_id else {}
    properties: Table = {"id": int(edge.id), "startid": int(edge.start), "endid": int(edge.end)}
    properties |= {"cost": float(edge.cost)} if edge.cost is not None else {}
    ends = [[float(at.x), float(at.y)] for at in (floor.vertices[edge.start], floor.vertices[edge.end])]
    more = own.get("geometry", {})
    is_multiple = more.get("type") == "MultiLineString"
    geometry = {"type": "LineString", "coordinates": [ends] if is_multiple else ends, **more}
    return _feature(own, properties, metadata, geometry)
