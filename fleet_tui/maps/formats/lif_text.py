"""Writes layouts of VDMA's LIF 1.0."""

from collections import Counter
from typing import Any

from msgspec.structs import replace

from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import MissingChoiceError, WriteChoices
from fleet_tui.maps.formats.json_text import to_json
from fleet_tui.maps.formats.lif import (
    CHARGING,
    ON_EDGES,
    ON_NODES,
    ORIENTATIONS,
    OWN,
    entries_of,
    station_labels,
)
from fleet_tui.maps.formats.purposes import Purpose, purpose_of
from fleet_tui.maps.formats.site_frame import in_site
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    Motion,
    Polyline,
    Station,
    one_way_edges,
)
from fleet_tui.model.graphs.ids import unused
from fleet_tui.text.language import Message

VERSION = "1.0.0"
_TURNS = {motion: degrees for degrees, motion in ORIENTATIONS.items()}


def write(document: GraphDocument, choices: WriteChoices) -> str:
    """Return the text of a document. Raises MissingChoiceError where no vehicle type may use a part of it."""
    if not choices.vehicle_type and lacks_vehicle_type(document):
        text = Message("LIF needs the vehicle type that may use the graph")
        raise MissingChoiceError(text, "--vehicle-type")
    document = with_distinct_ids(document)
    own = dict(document.extra.get(OWN, {}))
    meta = {
        "projectIdentification": document.name or "graph",
        "creator": "fleet-tui",
        "exportTimestamp": choices.at or "1970-01-01T00:00:00Z",
        "lifVersion": VERSION,
        **(own.pop("metaInformation", None) or {}),
    }
    used = set[str]()
    layouts = [
        _layout(floor, document.stations, choices.vehicle_type, used) for floor in document.floors.values()
    ]
    return to_json({"metaInformation": meta, "layouts": layouts, **own})


def lacks_vehicle_type(document: GraphDocument) -> bool:
    """Tell whether a vertex or an edge names no vehicle type that may use it."""
    return any(
        not all(map(entries_of, floor.vertices.values()))
        or not all(edge.per_vehicle for edge in floor.edges.values())
        for floor in document.floors.values()
    )


def repeated_ids(document: GraphDocument) -> set[str]:
    """Return the vertex ids that several floors have; LIF has one name space for all layouts."""
    counted = Counter(id_ for floor in document.floors.values() for id_ in floor.vertices)
    return {id_ for id_, count in counted.items() if count > 1}


def with_distinct_ids(document: GraphDocument) -> GraphDocument:
    """Return the document with the floor's name before ids that several floors have."""
    repeated = repeated_ids(document)
    if not repeated:
        return document
    new = {
        (floor.name, id_): f"{floor.name}-{id_}" if id_ in repeated else id_
        for floor in document.floors.values()
        for id_ in floor.vertices
    }
    floors = {name: _renamed(floor, new) for name, floor in document.floors.items()}
    stations = tuple(
        replace(one, stops=tuple((stop[0], new.get(stop, stop[1])) for stop in one.stops))
        for one in document.stations
    )
    return replace(document, floors=floors, stations=stations)


def _renamed(floor: DocumentFloor, new: dict[tuple[str, str], str]) -> DocumentFloor:
    ids = {id_: new[floor.name, id_] for id_ in floor.vertices}
    vertices = {ids[id_]: replace(vertex, id=ids[id_]) for id_, vertex in floor.vertices.items()}
    edges = {
        id_: replace(edge, start=ids.get(edge.start, edge.start), end=ids.get(edge.end, edge.end))
        for id_, edge in floor.edges.items()
    }
    return replace(floor, vertices=vertices, edges=edges)


def _layout(floor: DocumentFloor, stations: tuple[Station, ...], vehicle: str, used: set[str]) -> Table:
    floor = in_site(floor)
    named = station_labels(stations, floor.name)
    own = dict(floor.extra.get(OWN, {}))
    edges = []
    for way in one_way_edges(floor.edges.values(), floor.edges):
        id_ = unused(way.id, used) if way.id not in used else unused(f"{floor.name}-{way.id}", used)
        used.add(id_)
        edges.append(_edge(replace(way, id=id_), floor, vehicle))
    return {
        "layoutId": floor.name,
        "layoutVersion": own.pop("layoutVersion", "1"),
        **own,
        "nodes": [_node(one, named.get(one.id, ""), vehicle) for one in floor.vertices.values()],
        "edges": edges,
        "stations": [_station(one) for one in stations if _is_on(one, floor.name)],
    }


def _is_on(station: Station, floor: str) -> bool:
    own = station.extra.get(OWN, {})
    return (station.stops[0][0] if station.stops else own.get("layoutId", floor)) == floor


def _node(vertex: DocumentVertex, named: str, vehicle: str) -> Table:
    own = dict(vertex.extra.get(OWN, {}))
    position = {"x": float(vertex.x), "y": float(vertex.y), **own.pop("nodePosition", {})}
    entries: list[Table] = [dict(one) for one in entries_of(vertex)] or [{"vehicleTypeId": vehicle}]
    if vertex.heading is not None and vertex.heading not in [one.get("theta") for one in entries]:
        entries = [{**one, "theta": float(vertex.heading)} for one in entries]
    if purpose_of(vertex.type) is Purpose.CHARGER and not any(map(_charges, entries)):
        action = {"actionType": CHARGING, "requirementType": "CONDITIONAL", "blockingType": "HARD"}
        entries = [{**one, "actions": [*one.get("actions", []), action]} for one in entries]
    name = {"nodeName": vertex.label} if vertex.label and vertex.label != named else {}
    own[ON_NODES] = entries
    return {"nodeId": vertex.id, **name, "nodePosition": position, **own}


def _charges(entry: Table) -> bool:
    return any(action.get("actionType") == CHARGING for action in entry.get("actions", []))


def _edge(edge: DocumentEdge, floor: DocumentFloor, vehicle: str) -> Table:
    entries = [{"vehicleTypeId": type_, **values} for type_, values in edge.per_vehicle.items()]
    entries = entries or [_new_entry(edge, floor, vehicle)]
    if edge.speed is not None and edge.speed not in [one.get("maxSpeed") for one in entries]:
        entries = [{**one, "maxSpeed": float(edge.speed)} for one in entries]
    ends = {"edgeId": edge.id, "startNodeId": edge.start, "endNodeId": edge.end}
    return {**ends, **edge.extra.get(OWN, {}), ON_EDGES: entries}


def _new_entry(edge: DocumentEdge, floor: DocumentFloor, vehicle: str) -> Table:
    found: Table = {"vehicleTypeId": vehicle, "orientationType": "TANGENTIAL", "rotationAllowed": True}
    if edge.motion is not Motion.ANY:
        found["vehicleOrientation"] = _TURNS[edge.motion]
    if edge.control_points:
        start, end = (floor.vertices[id_] for id_ in (edge.start, edge.end))
        found["trajectory"] = _trajectory(((start.x, start.y), *edge.control_points, (end.x, end.y)), edge)
    return found


def _trajectory(points: Polyline, edge: DocumentEdge) -> Table:
    """Return a curve as NURBS: as cubic pieces or as a polyline where the plant says so, else one Bezier."""
    kind = edge.extra.get("opentcs", {}).get("connectionType")
    degree = 1 if kind == "POLYPATH" else 3 if kind == "BEZIER_3" and len(points) == 7 else len(points) - 1
    pieces = (len(points) - 1) // degree
    inner = [n / pieces for n in range(1, pieces) for _ in range(degree)]
    return {
        "degree": degree,
        "knotVector": [0.0] * (degree + 1) + inner + [1.0] * (degree + 1),
        "controlPoints": [{"x": float(x), "y": float(y), "weight": 1.0} for x, y in points],
    }


def _station(station: Station) -> Table:
    own = {key: value for key, value in station.extra.get(OWN, {}).items() if key != "layoutId"}
    position: dict[str, Any] = {
        key: value
        for key, value in (("x", station.x), ("y", station.y), ("theta", station.yaw))
        if value is not None
    }
    position |= own.pop("stationPosition", {})
    name = (
        {}
        if own.pop("unnamed", False) and own.get("stationId") == station.name
        else {"stationName": station.name}
    )
    return {
        "stationId": own.pop("stationId", station.name),
        "interactionNodeIds": [vertex for _, vertex in station.stops],
        **name,
        **({"stationHeight": station.height} if station.height is not None else {}),
        **({"stationPosition": position} if position else {}),
        **own,
    }
