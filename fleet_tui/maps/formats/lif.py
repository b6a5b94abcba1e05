"""Reads layouts of VDMA's LIF 1.0: JSON, metres, a layout for each floor, values for each type of vehicle."""

import math
from collections.abc import Iterator
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, MissingChoiceError, ReadChoices
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Motion,
    Polyline,
    Station,
    merge_opposites,
)
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message

OWN = GraphFormat.LIF.value
ON_NODES = "vehicleTypeNodeProperties"
ON_EDGES = "vehicleTypeEdgeProperties"
CHARGING = "startCharging"
ORIENTATIONS = {0.0: Motion.FORWARD, 180.0: Motion.BACKWARD}
"""Motions by a tangential orientation in degrees."""
MOST_TYPES = 1000


FARTHEST = 2000.0
"""Metres; a layout that extends farther has probably another unit."""
LENGTHS = {"m": 1.0, "mm": 0.001}
ANGLES = {"rad": 1.0, "deg": math.pi / 180}
_NUMBERS = frozenset(
    {"x", "y", "theta", "stationHeight", "maxSpeed", "maxRotationSpeed", "vehicleOrientation", "orientation"}
)
_PLACES = ("nodePosition", "stationPosition", "controlPoints")


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file. Raises GraphError."""
    tree, notes = in_si_units(_as_version_1(fields.mapping(tree, "file")), choices)
    table = dict(tree)
    meta = fields.optional_mapping(table.get("metaInformation"), "metaInformation")
    layouts = fields.elements(table.pop("layouts", None), "layouts", fields.MOST_FLOORS)
    floors, stations = dict[str, DocumentFloor](), list[Station]()
    for n, layout in enumerate(layouts):
        floor, at = _layout(dict(fields.mapping(layout, f"layouts[{n}]")), n, choices.vehicle_type)
        if floor.name in floors:
            raise GraphError(
                Message("layouts[{n}]: layoutId {name} twice: rename one", n=n, name=f"{floor.name[:40]!r}")
            )
        floors[floor.name] = floor
        stations += at
    types = {type_ for floor in floors.values() for type_ in vehicle_types(floor)}
    if choices.vehicle_type and types and choices.vehicle_type not in types:
        listed = ", ".join(sorted(types)[:5])
        raise GraphError(
            Message(
                "no vehicle type {vehicle_type} in the file: it has {listed}",
                vehicle_type=f"{choices.vehicle_type[:40]!r}",
                listed=listed,
            )
        )
    name = str(meta.get("projectIdentification") or "")
    document = GraphDocument(name, floors, (), tuple(stations), extra=fields.rest(OWN, table))
    return GraphFile(GraphFormat.LIF, document, notes)


def is_version_2(tree: Table) -> bool:
    """Tell whether the layouts of a file are those of origins, as LIF 2.0 has them."""
    origins = tree.get("origins")
    return isinstance(origins, list) and any(isinstance(one, dict) and "layouts" in one for one in origins)


def _as_version_1(tree: Table) -> Table:
    """Return the contents of a file of LIF 2.0 as 1.0 has them: vehicles by their former name, and layouts
    without their origins. Texts that are numbers become numbers in both."""
    tree = _renamed(tree, 0)
    if not is_version_2(tree):
        return tree
    origins = [fields.mapping(one, "origins") for one in tree.pop("origins")]
    return {**tree, "layouts": [layout for one in origins for layout in _list(one.get("layouts"))]}


def _renamed(value: Any, depth: int) -> Any:
    if depth > 100:
        raise GraphError(Message("nested too deep"))
    if isinstance(value, list):
        return [_renamed(one, depth + 1) for one in value]
    if not isinstance(value, dict):
        return value
    return {
        key.replace("mobileRobotType", "vehicleType"): _read_number(one)
        if key in _NUMBERS
        else _renamed(one, depth + 1)
        for key, one in value.items()
    }


def _read_number(value: Any) -> Any:
    return fields.number(value, "") if isinstance(value, str) and fields.is_number(value) else value


def vehicle_types(floor: DocumentFloor) -> set[str]:
    """Return the types of vehicles that a floor names."""
    found = {type_ for edge in floor.edges.values() for type_ in edge.per_vehicle}
    return found | {
        str(entry.get("vehicleTypeId")) for vertex in floor.vertices.values() for entry in entries_of(vertex)
    }


def entries_of(vertex: DocumentVertex) -> list[Table]:
    """Return the values of a vertex for each type of vehicle, as the file has them."""
    own = vertex.extra.get(OWN, {})
    return list(own.get(ON_NODES) or []) if isinstance(own, dict) else []


def _layout(table: Table, n: int, vehicle: str) -> tuple[DocumentFloor, list[Station]]:
    name = fields.required(table, "layoutId", fields.identifier, f"layouts[{n}]")
    where = f"layout {name[:40]}"
    nodes = fields.vertex_elements(table.pop("nodes", None), f"{where} nodes")
    edges = fields.edge_elements(table.pop("edges", None), f"{where} edges")
    parts = fields.vertex_elements(table.pop("stations", None), f"{where} stations")
    stations = [_station(dict(fields.mapping(one, f"{where} station")), name, where) for one in parts]
    named = station_labels(tuple(stations), name)
    vertices = {one.id: one for one in _vertices(nodes, where, vehicle, named)}
    found = merge_opposites(_edges(edges, where, vehicle, vertices))
    return DocumentFloor(name, vertices, found, extra=fields.rest(OWN, table)), stations


def station_labels(stations: tuple[Station, ...], floor: str) -> dict[str, str]:
    """Return the names of stations with one vertex, by that vertex: labels of vertices without a name."""
    found = dict[str, str]()
    for station in stations:
        if len(station.stops) == 1 and station.stops[0][0] == floor:
            found.setdefault(station.stops[0][1], station.name)
    return found


def _tables(parts: list[Any], key: str, where: str) -> Iterator[tuple[str, tuple[str, ...], Table]]:
    """Yield each element with its distinct id and the id of the file that it repeats."""
    tables = [dict(fields.mapping(one, f"{where} element {n}")) for n, one in enumerate(parts)]
    ids = [
        fields.required(one, key, fields.identifier, f"{where} element {n}") for n, one in enumerate(tables)
    ]
    for (id_, repeats), table in zip(distinct(ids), tables, strict=True):
        yield id_, repeats, table


def _entries(table: Table, key: str, where: str) -> list[Table]:
    entries = fields.elements(table.get(key), f"{where} {key}", MOST_TYPES)
    return [dict(fields.mapping(entry, f"{where} {key}")) for entry in entries]


def agreed(entries: list[Table], key: str, vehicle: str, where: str) -> float | None:
    """Return a vehicle type's value; without a chosen type the one on which all that have it agree."""
    chosen = [one for one in entries if not vehicle or one.get("vehicleTypeId") == vehicle]
    found = [fields.optional(dict(one), key, fields.number, where) for one in chosen]
    values = {value for value in found if value is not None}
    return values.pop() if len(values) == 1 else None


def _vertices(parts: list[Any], where: str, vehicle: str, named: dict[str, str]) -> Iterator[DocumentVertex]:
    for id_, repeats, table in _tables(parts, "nodeId", f"{where} nodes"):
        at = f"{where} node {(*repeats, id_)[0][:40]}"
        position = dict(fields.required(table, "nodePosition", fields.mapping, at))
        x, y = (fields.required(position, axis, fields.number, at) for axis in ("x", "y"))
        if position:
            table["nodePosition"] = position
        entries = _entries(table, ON_NODES, at)
        label = fields.optional(table, "nodeName", fields.text, at) or named.get(id_, "")
        actions = {
            str(fields.mapping(action, f"{at} actions").get("actionType"))
            for entry in entries
            for action in fields.elements(entry.get("actions"), f"{at} actions", MOST_TYPES)
        }
        type_ = "charger" if CHARGING in actions else ""
        heading = agreed(entries, "theta", vehicle, at)
        yield DocumentVertex(id_, x, y, label, type_, heading, "", fields.rest(OWN, table), repeats)


def _edges(
    parts: list[Any], where: str, vehicle: str, vertices: dict[str, DocumentVertex]
) -> Iterator[DocumentEdge]:
    for id_, repeats, table in _tables(parts, "edgeId", f"{where} edges"):
        at = f"{where} edge {(*repeats, id_)[0][:40]}"
        start, end = (
            fields.required(table, key, fields.identifier, at) for key in ("startNodeId", "endNodeId")
        )
        entries = _entries(table, ON_EDGES, at)
        table.pop(ON_EDGES, None)
        types = [fields.required(dict(one), "vehicleTypeId", fields.text, at) for one in entries]
        if len(set(types)) < len(types):
            raise GraphError(Message("{at}: a vehicle type is listed twice: remove one", at=at))
        turn = agreed([one for one in entries if _is_tangential(one)], "vehicleOrientation", vehicle, at)
        yield DocumentEdge(
            id_,
            start,
            end,
            two_way=False,
            speed=agreed(entries, "maxSpeed", vehicle, at),
            motion=Motion.ANY if turn is None else ORIENTATIONS.get(turn, Motion.ANY),
            control_points=_curve(entries, vehicle, at, vertices.get(start), vertices.get(end)),
            per_vehicle={
                type_: {key: value for key, value in entry.items() if key != "vehicleTypeId"}
                for type_, entry in zip(types, entries, strict=True)
            },
            extra=fields.rest(OWN, table),
            repeats=repeats,
        )


def _is_tangential(entry: Table) -> bool:
    return bool(entry.get("orientationType", "TANGENTIAL") == "TANGENTIAL")


def _curve(
    entries: list[Table], vehicle: str, where: str, start: DocumentVertex | None, end: DocumentVertex | None
) -> Polyline:
    """Return the inner control points of the first trajectory; those on the vertices are left out."""
    for entry in entries:
        is_other = vehicle and entry.get("vehicleTypeId") != vehicle
        if is_other or not isinstance(entry.get("trajectory"), dict):
            continue
        points = fields.elements(entry["trajectory"].get("controlPoints"), f"{where} trajectory", 1000)
        tables = [fields.mapping(point, f"{where} trajectory") for point in points]
        places = [(fields.number(one.get("x"), where), fields.number(one.get("y"), where)) for one in tables]
        if start and places and math.dist(places[0], (start.x, start.y)) < 1e-6:
            places = places[1:]
        if end and places and math.dist(places[-1], (end.x, end.y)) < 1e-6:
            places = places[:-1]
        return tuple(places)
    return ()


def _station(table: Table, floor: str, where: str) -> Station:
    id_ = fields.required(table, "stationId", fields.identifier, f"{where} station")
    at = f"{where} station {id_[:40]}"
    name = fields.optional(table, "stationName", fields.text, at)
    nodes = fields.vertex_elements(table.pop("interactionNodeIds", None), f"{at} interactionNodeIds")
    stops = tuple((floor, fields.identifier(node, at)) for node in nodes)
    position = dict(fields.optional_mapping(table.pop("stationPosition", None), at))
    x, y, yaw = (fields.optional(position, key, fields.number, at) for key in ("x", "y", "theta"))
    height = fields.optional(table, "stationHeight", fields.number, at)
    if position:
        table["stationPosition"] = position
    own = {"stationId": id_, "layoutId": floor, **table, **({} if name is not None else {"unnamed": True})}
    return Station(name if name is not None else id_, stops, x, y, yaw, height, {OWN: own})


def in_si_units(tree: Table, choices: ReadChoices) -> tuple[Table, tuple[str, ...]]:
    """Return the contents of a file in metres and radians, with notes on doubtful units: they are so by the
    format, but some files have millimetres or degrees.

    Raises MissingChoiceError where `choices` wants to be asked and a unit is in doubt.
    """
    farthest, turn = _largest(tree)
    notes = list[str]()
    if farthest > FARTHEST and not choices.lengths:
        text = Message(
            "positions up to {farthest}: metres by the format, probably millimetres", farthest=f"{farthest:g}"
        )
        _ask(choices, text, "--lengths", tuple(LENGTHS))
        notes.append(f"{text}; read as metres (--lengths mm for millimetres)")
    if turn > math.tau and not choices.angles:
        text = Message("theta up to {turn}: radians by the format, probably degrees", turn=f"{turn:g}")
        _ask(choices, text, "--angles", tuple(ANGLES))
        notes.append(f"{text}; read as radians (--angles deg for degrees)")
    length, angle = LENGTHS.get(choices.lengths, 1.0), ANGLES.get(choices.angles, 1.0)
    if (length, angle) == (1.0, 1.0):
        return tree, tuple(notes)
    return _scaled(tree, length, angle, False, 0), tuple(notes)


def _ask(choices: ReadChoices, text: Message, option: str, units: tuple[str, ...]) -> None:
    if choices.ask:
        raise MissingChoiceError(text, option, units)


def _largest(tree: Table) -> tuple[float, float]:
    """Return the largest x or y of a node, and the largest theta."""
    positions, turns = [0.0], [0.0]
    for layout in _list(tree.get("layouts")):
        for node in _list(_get(layout, "nodes")):
            position = _get(node, "nodePosition")
            positions += [abs(one) for one in (_get(position, "x"), _get(position, "y")) if _is_number(one)]
            thetas = [_get(entry, "theta") for entry in _list(_get(node, "vehicleTypeNodeProperties"))]
            turns += [abs(one) for one in thetas if _is_number(one)]
    return max(positions), max(turns)


def _get(value: Any, key: str) -> Any:
    return value.get(key) if isinstance(value, dict) else None


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _is_number(value: Any) -> bool:
    """Tell whether a value is a number of a size that a float can have."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e300


def _scaled(value: Any, length: float, angle: float, placed: bool, depth: int) -> Any:
    """Return a copy with the x and y of places, heights and thetas in metres and radians."""
    if depth > 100:
        raise GraphError(Message("nested too deep"))
    if isinstance(value, list):
        return [_scaled(one, length, angle, placed, depth + 1) for one in value]
    if not isinstance(value, dict):
        return value
    found = {}
    for key, one in value.items():
        if _is_number(one) and (key == "stationHeight" or (placed and key in ("x", "y"))):
            found[key] = one * length
        elif _is_number(one) and key == "theta":
            found[key] = one * angle
        else:
            found[key] = _scaled(one, length, angle, placed or key in _PLACES, depth + 1)
    return found
