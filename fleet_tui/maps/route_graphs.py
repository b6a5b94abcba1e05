"""Route graphs from files: GeoJSON as Nav2's route server reads it, element by element; others as a whole."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec.structs import replace

from fleet_tui.config.small_file import read_text
from fleet_tui.maps.formats.graph_file import MissingChoiceError, ReadChoices
from fleet_tui.maps.formats.json_text import in_line
from fleet_tui.maps.formats.reading import read_graph
from fleet_tui.model.events import FloorGraphLoaded
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.model.graphs.live import role_of, route_graph
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.ros.facts import is_place
from fleet_tui.text.errors import GraphError, WireError
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.limits import LONGEST_NAME, MOST_EDGES, MOST_VERTICES, too_many, truncate

MAX_FILE = 40_000_000
"""Maximum bytes: some 500 for each of the maximum vertices and edges."""
LINES = ("LineString", "MultiLineString")
_Id = Annotated[int, msgspec.Meta(ge=0, lt=2**32)]


FARTHEST = 1e9
"""Metres; a vertex farther off is on no floor."""


class _Metadata(msgspec.Struct):
    """Free in Nav2: a value that is not text is no label and no class."""

    name: Any = None
    class_: Any = msgspec.field(default=None, name="class")


class _Properties(msgspec.Struct):
    id: _Id
    startid: _Id | None = None
    endid: _Id | None = None
    metadata: _Metadata | None = None


class _Geometry(msgspec.Struct):
    type: str
    coordinates: msgspec.Raw = msgspec.Raw(b"null")


class _Feature(msgspec.Struct):
    properties: _Properties
    geometry: _Geometry


class _Collection(msgspec.Struct):
    type: str = ""
    features: list[msgspec.Raw] | None = None


def load_floor_graph(floor: str, path: Path) -> FloorGraphLoaded:
    """Load a floor's graph file; the event has its errors."""
    try:
        return _read(floor, path)
    except GraphError as problem:
        return FloorGraphLoaded(
            floor, None, {}, Message("graph {name}: {problem}", name=path.name, problem=problem)
        )


def _read(floor: str, path: Path) -> FloorGraphLoaded:
    text, faults = _text_of(path), list[str]()
    raw = _features(text)
    if raw is None:
        # Only for other formats: their parsers would delay the start of every console.
        from fleet_tui.maps.route_graphs import read_site_graph

        graph, labels, faults = read_site_graph(floor, text)
    else:
        graph, labels = _read_features(raw, faults)
    problem = Message("graph {name}: {summary}", name=path.name, summary=_summary(faults)) if faults else ""
    return FloorGraphLoaded(floor, graph, labels, problem)


def _read_features(raw: list[msgspec.Raw], faults: list[str]) -> tuple[RouteGraph, dict[str, str]]:
    features = read_all(_feature, raw, Message("features"), MOST_VERTICES + MOST_EDGES, faults)
    vertices, labels = _vertices((one for one in features if one.geometry.type == "Point"), faults)
    if not vertices:
        reason = f": {faults[0]}" if faults else ""
        raise GraphError(
            Message("has no vertices{reason}: expected features with an id and a Point", reason=reason)
        )
    return _graph(vertices, (one for one in features if one.geometry.type in LINES), faults), labels


def _summary(faults: list[str]) -> Message:
    more = Message(", {faults} more faults", faults=len(faults) - 1) if len(faults) > 1 else ""
    return verbatim(truncate(faults[0])) + more


def _text_of(path: Path) -> str:
    try:
        return read_text(path, MAX_FILE)
    except FileNotFoundError:
        raise GraphError(Message("no such file")) from None
    except (OSError, ValueError) as problem:
        raise GraphError(Message("unreadable: {problem}", problem=problem)) from None


def _features(text: str) -> list[msgspec.Raw] | None:
    """Return the features of a file, still encoded; None if it is no GeoJSON. Raises GraphError."""
    if not text.lstrip().startswith("{"):
        return None
    try:
        found = msgspec.json.decode(text, type=_Collection)
    except msgspec.ValidationError:
        return None
    except (msgspec.DecodeError, ValueError) as problem:
        raise GraphError(Message("not JSON: {problem}", problem=in_line(str(problem), text))) from None
    except RecursionError:
        raise GraphError(Message("nested too deep")) from None
    return found.features if found.type == "FeatureCollection" else None


def _feature(raw: msgspec.Raw) -> _Feature:
    """Return a feature of a graph. Raises WireError."""
    try:
        feature = msgspec.json.decode(raw, type=_Feature)
    except (msgspec.MsgspecError, ValueError) as problem:
        raise WireError(str(problem)) from None
    type_ = feature.geometry.type
    if type_ != "Point" and type_ not in LINES:
        raise WireError(f"geometry {truncate(type_, 20)!r} is neither a Point nor a line: left out")
    return feature


def _vertices(points: Iterable[_Feature], faults: list[str]) -> tuple[dict[str, Vertex], dict[str, str]]:
    """Return vertices by id, and the labels of those that have one. Of two with one id the later is used."""
    vertices, labels, read = dict[str, Vertex](), dict[str, str](), list(points)
    if len(read) > MOST_VERTICES:
        faults.append(too_many(len(read), MOST_VERTICES, Message("vertices")))
    for point in read[:MOST_VERTICES]:
        id_, metadata = str(point.properties.id), point.properties.metadata or _Metadata()
        try:
            x, y = _place(point.geometry.coordinates)
        except WireError as problem:
            faults.append(Message("vertex {id}: {problem}: left out", id=id_, problem=problem))
            continue
        if id_ in vertices:
            faults.append(Message("vertex {id} duplicated: the last one is used", id=id_))
            labels.pop(id_, None)
        type_ = _text(metadata.class_)
        vertices[id_] = Vertex(id_, x, y, role_of(type_), type_)
        if label := _text(metadata.name):
            labels[id_] = label
    return vertices, labels


def _place(coordinates: msgspec.Raw) -> tuple[float, float]:
    """Return x and y in metres; a height after them is ignored. Raises WireError."""
    try:
        x, y, *_ = msgspec.json.decode(coordinates, type=list[float])
    except (msgspec.MsgspecError, ValueError) as problem:
        raise WireError(f"coordinates must be [x, y]: {problem}") from None
    if not is_place(x, y):
        raise WireError(f"({x:g}, {y:g}) m is out of range")
    return x, y


def _text(value: object) -> str:
    """Return a label or class; a whole number is valid, too."""
    if isinstance(value, int) and not isinstance(value, bool):
        value = str(value)
    return truncate(value.strip(), LONGEST_NAME) if isinstance(value, str) else ""


def _graph(vertices: Mapping[str, Vertex], lines: Iterable[_Feature], faults: list[str]) -> RouteGraph:
    """Join vertices. Edges go one way in such a file: only if each has its opposite, pairs are merged.

    Ids of edges may repeat, as in files that come with Nav2: new ones are given as a graph editor does.
    """
    ways, read = dict[tuple[str, str], Edge](), list(lines)
    if len(read) > MOST_EDGES:
        faults.append(too_many(len(read), MOST_EDGES, Message("edges")))
    ids = distinct((str(line.properties.id) for line in read), vertices)
    for (id_, _), line in zip(ids, read[:MOST_EDGES], strict=False):
        ends = line.properties.startid, line.properties.endid
        way = str(ends[0]), str(ends[1])
        if None in ends:
            faults.append(Message("edge {id} has no startid or no endid: left out", id=id_))
        elif unknown := [end for end in way if end not in vertices]:
            faults.append(
                Message("edge {id} names unknown vertex {vertex}: left out", id=id_, vertex=unknown[0])
            )
        else:
            if way in ways:
                faults.append(
                    Message(
                        "duplicate edge from {start} to {end}: the last one is used", start=way[0], end=way[1]
                    )
                )
            ways[way] = Edge(id_, *way)
    if any((end, start) not in ways for start, end in ways):
        return RouteGraph(vertices, tuple(ways.values()), directed=True)
    pairs = {frozenset(way): edge for way, edge in reversed(ways.items())}
    return RouteGraph(vertices, tuple(_with_back(one, ways) for one in reversed(pairs.values())))


def _with_back(edge: Edge, ways: Mapping[tuple[str, str], Edge]) -> Edge:
    back = ways[edge.end, edge.start].id
    return replace(edge, reverse_id=back) if back != edge.id else edge


def read_site_graph(floor: str, text: str) -> tuple[RouteGraph, dict[str, str], list[str]]:
    """Return the graph of a floor, its labels, and the faults of elements that are left out.

    Raises GraphError.
    """
    try:
        document = read_graph(text, None, ReadChoices(floor)).document
    except MissingChoiceError as missing:
        remedy = Message(
            "make a file of it: fleet-tui graph convert IN OUT {option} ...", option=missing.option
        )
        raise GraphError(Message("{missing}; {remedy}", missing=missing, remedy=remedy)) from None
    found, faults = _usable(_floor(document, floor))
    if not found.vertices:
        raise GraphError(Message("has no vertices"))
    graph, labels = route_graph(found)
    shown = {id_: truncate(label.strip(), LONGEST_NAME) for id_, label in labels.items() if label.strip()}
    return graph, shown, faults


def _floor(document: GraphDocument, name: str) -> DocumentFloor:
    """Return the floor of that name, else the only one. Raises GraphError."""
    if name in document.floors:
        return document.floors[name]
    if len(document.floors) == 1:
        return next(iter(document.floors.values()))
    names = ", ".join(list(document.floors)[:5]) or "none"
    raise GraphError(Message("has the floors {names}: none is called {name}", names=names, name=name))


def _usable(floor: DocumentFloor) -> tuple[DocumentFloor, list[str]]:
    """Return the floor without vertices at no place and edges without both ends, and the faults."""
    vertices = {id_: v for id_, v in floor.vertices.items() if abs(v.x) <= FARTHEST and abs(v.y) <= FARTHEST}
    faults: list[str] = [
        Message("vertex {id} has no position: left out", id=id_)
        for id_ in floor.vertices
        if id_ not in vertices
    ]
    edges = {}
    for id_, edge in floor.edges.items():
        lost = [end for end in (edge.start, edge.end) if end not in vertices]
        if lost:
            faults.append(
                Message("edge {id} names unknown vertex {vertex}: left out", id=id_, vertex=lost[0])
            )
        else:
            edges[id_] = edge
    return replace(floor, vertices=vertices, edges=edges), faults
