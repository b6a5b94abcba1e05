"""The route graphs of a site as files hold them and an editor changes them. Metres and radians.

Values only: an edit makes a new floor with copies of its mappings, so that undo keeps the old one.
"""

from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any, TypeVar

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.graphs.ids import is_number, next_id, unused

Extra = Mapping[str, Any]
"""Contents of a file beyond this model, by the name of its format; written back only to that format."""
Site = tuple[float, float, float]
"""x, y in metres and yaw in radians."""
Stop = tuple[str, str]
"""A floor and a vertex on it."""
Polyline = tuple[tuple[float, float], ...]
"""x, y in metres of each point."""

VERSION = 1
IDENTITY: Site = (0.0, 0.0, 0.0)


class GraphFormat(Enum):
    """The formats of graph files, by their names on the command line."""

    NATIVE = "native"
    OH = "oh"
    RMF = "rmf"
    RMF_BUILDING = "rmf-building"
    RMF_SITE = "rmf-site"
    GEOJSON = "geojson"
    LIF = "lif"
    OPENTCS = "opentcs"


class Motion(Enum):
    """The direction in which a robot may face while it drives along an edge."""

    ANY = "any"
    FORWARD = "forward"
    BACKWARD = "backward"


class DocumentVertex(Struct, frozen=True):
    """A place on a floor, unrounded. type: the robot stack's own word; heading: radians, None for any;
    source_id: the id in a format whose ids this one can't have; repeats: the ids in the file that was read
    that a later element has, too; not written."""

    id: str
    x: float
    y: float
    label: str = ""
    type: str = ""
    heading: float | None = None
    source_id: str = ""
    extra: Extra = {}
    repeats: tuple[str, ...] = ()


class DocumentEdge(Struct, frozen=True):
    """A connection from one vertex to another, or both ways.

    reverse_id: the id of the opposite direction, where the file had two edges; speed: m/s; speed_percent: of
    the robot's own maximum; length: metres, where it is not the distance; control_points: of a curve;
    per_vehicle: the values of each type of vehicle; source_id, repeats: as for a vertex.
    """

    id: str
    start: str
    end: str
    two_way: bool = True
    reverse_id: str = ""
    speed: float | None = None
    speed_percent: float | None = None
    cost: float | None = None
    locked: bool = False
    motion: Motion = Motion.ANY
    length: float | None = None
    control_points: Polyline = ()
    per_vehicle: Mapping[str, Any] = {}
    source_id: str = ""
    extra: Extra = {}
    repeats: tuple[str, ...] = ()

    @property
    def reversed(self) -> "DocumentEdge":
        """Return the same connection the other way round, under its other id."""
        return replace(
            self,
            id=self.reverse_id,
            reverse_id=self.id,
            start=self.end,
            end=self.start,
            control_points=self.control_points[::-1],
        )


class MapReference(Struct, frozen=True):
    """The map image of a floor. resolution: metres per pixel; origin: the place of its lower left pixel."""

    file: str
    resolution: float = 0.05
    origin: Site = IDENTITY


class DocumentFloor(Struct, frozen=True):
    """The graph of one floor. to_site: its frame's place in the site's, for formats with one frame for all
    floors."""

    name: str
    vertices: Mapping[str, DocumentVertex] = {}
    edges: Mapping[str, DocumentEdge] = {}
    frame_id: str = ""
    map: MapReference | None = None
    to_site: Site = IDENTITY
    extra: Extra = {}

    @property
    def labels(self) -> dict[str, str]:
        """Return the labels by vertex id."""
        return {id_: vertex.label for id_, vertex in self.vertices.items() if vertex.label}


class Lift(Struct, frozen=True):
    """A lift and the vertices in its cabin. size: width and depth in metres."""

    name: str
    stops: tuple[Stop, ...] = ()
    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    size: tuple[float, float] | None = None
    extra: Extra = {}


class Station(Struct, frozen=True):
    """A place where robots interact with something, from one or more vertices. Metres, radians."""

    name: str
    stops: tuple[Stop, ...] = ()
    x: float | None = None
    y: float | None = None
    yaw: float | None = None
    height: float | None = None
    extra: Extra = {}


class GraphDocument(Struct, frozen=True):
    """The graphs of a site, by the names of its floors."""

    name: str = ""
    floors: Mapping[str, DocumentFloor] = {}
    lifts: tuple[Lift, ...] = ()
    stations: tuple[Station, ...] = ()
    version: int = VERSION
    extra: Extra = {}

    def with_floor(self, floor: DocumentFloor) -> "GraphDocument":
        """Return the document with this floor in place of the one of its name."""
        return replace(self, floors={**self.floors, floor.name: floor})

    def only(self, name: str) -> "GraphDocument":
        """Return the document with one of its floors, and the stops on it."""
        lifts = tuple(_on(lift, name) for lift in self.lifts)
        stations = tuple(_on(station, name) for station in self.stations)
        return replace(
            self,
            floors={name: self.floors[name]},
            lifts=tuple(lift for lift in lifts if lift.stops),
            stations=tuple(station for station in stations if station.stops),
        )


def of_floor(floor: DocumentFloor, name: str = "") -> GraphDocument:
    return GraphDocument(name or floor.name, {floor.name: floor})


def merge_opposites(edges: Iterable[DocumentEdge]) -> dict[str, DocumentEdge]:
    """Return edges by id; two one-way edges become one if they differ only in direction and id."""
    found = dict[str, DocumentEdge]()
    waiting = dict[tuple[str, str], list[str]]()
    for edge in edges:
        others = waiting.get((edge.end, edge.start), [])
        same = next((id_ for id_ in others if not edge.two_way and _are_opposite(found[id_], edge)), None)
        if same is not None:
            others.remove(same)
            repeats = found[same].repeats + edge.repeats
            found[same] = replace(found[same], two_way=True, reverse_id=edge.id, repeats=repeats)
            continue
        found[edge.id] = edge
        if not edge.two_way and edge.start != edge.end:
            waiting.setdefault((edge.start, edge.end), []).append(edge.id)
    return found


def one_way_edges(edges: Iterable[DocumentEdge], taken: Iterable[str]) -> list[DocumentEdge]:
    """Return an edge for each direction. An opposite one without an id gets a new one, beyond those taken."""
    wanted, found = list(edges), list[DocumentEdge]()
    used = {*taken, *(edge.reverse_id for edge in wanted)}
    free = int(next_id(used))
    for edge in wanted:
        found.append(replace(edge, two_way=False))
        if not edge.two_way:
            continue
        other = replace(edge.reversed, two_way=False)
        if not other.id and is_number(edge.id):
            other, free = replace(other, id=str(free)), free + 1
        elif not other.id:
            other = replace(other, id=unused(f"{edge.id}-reverse", used))
        used.add(other.id)
        found.append(other)
    return found


def _are_opposite(one: DocumentEdge, other: DocumentEdge) -> bool:
    turned = replace(
        other.reversed, id=one.id, reverse_id=one.reverse_id, source_id=one.source_id, repeats=one.repeats
    )
    return turned == one


_Part = TypeVar("_Part", Lift, Station)


def _on(part: _Part, floor: str) -> _Part:
    return replace(part, stops=tuple(stop for stop in part.stops if stop[0] == floor))
