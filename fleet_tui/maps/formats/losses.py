"""The parts of a document that a format can't hold, counted before it is written."""

from collections.abc import Iterable, Iterator

from msgspec import Struct

from fleet_tui.maps.formats import geojson, oh
from fleet_tui.maps.formats.lif_text import repeated_ids
from fleet_tui.maps.formats.purposes import Purpose, purpose_of
from fleet_tui.maps.formats.rmf import TYPES
from fleet_tui.model.graphs.document import (
    IDENTITY,
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Motion,
)
from fleet_tui.text.units import counted

F = GraphFormat
_KEPT: dict[GraphFormat, frozenset[str]] = {
    F.OH: frozenset(),
    F.RMF: frozenset({"speeds", "driving directions", "lifts", "places in the site"}),
    F.GEOJSON: frozenset({"speeds", "costs", "locked edges", "driving directions", "lengths", "frames"}),
    F.LIF: frozenset(
        {
            "speeds",
            "headings",
            "driving directions",
            "curves",
            "values per vehicle type",
            "stations",
            "places in the site",
        }
    ),
}
"""What each format holds of the parts that are counted here; native holds all."""
_IDS = {"vertex ids": ("vertex", "vertices"), "edge ids": ("edge", "edges")}


class Loss(Struct, frozen=True):
    """Parts of one sort that are lost, and how many."""

    what: str
    count: int

    def __str__(self) -> str:
        return f"{self.what}: {self.count}"

    @property
    def line(self) -> str:
        """Return the loss as a line of its own: elements stay when they lose their ids."""
        if self.what in _IDS:
            return f"new ids: {counted(self.count, *_IDS[self.what])}"
        return f"lost: {self}"


def losses(document: GraphDocument, format_: GraphFormat) -> tuple[Loss, ...]:
    """Return the losses of a document in a format, without those that do not occur."""
    if format_ is F.NATIVE or format_ not in _KEPT:
        return ()
    counted = [*_of_floors(document, format_), *_of_site(document)]
    kept = _KEPT[format_]
    found = [Loss(what, count) for what, count in counted if count and what not in kept]
    others = _details(document, format_)
    return (*found, *([Loss("details of other formats", others)] if others else []))


def _of_floors(document: GraphDocument, format_: GraphFormat) -> Iterator[tuple[str, int]]:
    floors = document.floors.values()
    vertices = [vertex for floor in floors for vertex in floor.vertices.values()]
    edges = [edge for floor in floors for edge in floor.edges.values()]
    yield from _new_ids(document, format_)
    yield "types", _types(document, format_)
    yield "headings", sum(vertex.heading is not None for vertex in vertices)
    yield "speeds", sum(edge.speed is not None for edge in edges)
    yield "speeds in per cent", sum(edge.speed_percent is not None for edge in edges)
    yield "costs", sum(edge.cost is not None for edge in edges)
    yield "locked edges", sum(edge.locked for edge in edges)
    yield "driving directions", sum(edge.motion is not Motion.ANY for edge in edges)
    yield "lengths", sum(edge.length is not None for edge in edges)
    yield "curves", sum(bool(edge.control_points) for edge in edges)
    yield "values per vehicle type", sum(bool(edge.per_vehicle) for edge in edges)


def _of_site(document: GraphDocument) -> Iterator[tuple[str, int]]:
    floors = document.floors.values()
    yield "lifts", len(document.lifts)
    yield "stations", len(document.stations)
    yield "map files", sum(floor.map is not None for floor in floors)
    yield "frames", sum(floor.frame_id not in ("", floor.name) for floor in floors)
    yield "places in the site", sum(floor.to_site != IDENTITY for floor in floors)


def _new_ids(document: GraphDocument, format_: GraphFormat) -> Iterator[tuple[str, int]]:
    vertices = edges = 0
    for floor in document.floors.values():
        if format_ in (F.OH, F.GEOJSON):
            found = (oh if format_ is F.OH else geojson).new_ids(floor)
            vertices, edges = vertices + found.vertices, edges + found.edges
        elif format_ is F.RMF:
            vertices += sum(id_ != str(n) for n, id_ in enumerate(floor.vertices))
            edges += _not_counted(floor.edges.values())
    if format_ is F.LIF:
        repeated = repeated_ids(document)
        vertices = sum(id_ in repeated for floor in document.floors.values() for id_ in floor.vertices)
    # Of elements with one id in a file all but one got another when it was read.
    for floor in document.floors.values() if format_ is not F.RMF else ():
        vertices += sum(len(vertex.repeats) for vertex in floor.vertices.values())
        edges += sum(len(edge.repeats) for edge in floor.edges.values())
    yield "vertex ids", vertices
    yield "edge ids", edges


def _not_counted(edges: Iterable[DocumentEdge]) -> int:
    """Return the number of edges whose ids are not their numbers in the list of lanes."""
    ids = [id_ for edge in edges for id_ in ((edge.id, edge.reverse_id) if edge.two_way else (edge.id,))]
    return len(set(ids) - {str(n) for n in range(len(ids))} - {""})


def _types(document: GraphDocument, format_: GraphFormat) -> int:
    """Return the number of vertices whose type is written as another word, or not at all."""
    if format_ in (F.OH, F.GEOJSON):
        return 0
    stops = {stop for lift in document.lifts for stop in lift.stops}
    return sum(
        vertex.type != _written(vertex, floor, stops, format_)
        for floor in document.floors.values()
        for vertex in floor.vertices.values()
    )


def _written(
    vertex: DocumentVertex, floor: DocumentFloor, stops: set[tuple[str, str]], format_: GraphFormat
) -> str:
    """Return the type that is read from the written file."""
    purpose = purpose_of(vertex.type)
    if format_ is F.LIF:
        return "charger" if purpose is Purpose.CHARGER else ""
    return "lift" if (floor.name, vertex.id) in stops else TYPES.get(purpose, "")


def _details(document: GraphDocument, format_: GraphFormat) -> int:
    """Return the number of parts with contents that only another format has."""
    floors = document.floors.values()
    extras = [document.extra, *(floor.extra for floor in floors)]
    extras += [lift.extra for lift in document.lifts] + [station.extra for station in document.stations]
    extras += [vertex.extra for floor in floors for vertex in floor.vertices.values()]
    extras += [edge.extra for floor in floors for edge in floor.edges.values()]
    return sum(bool(extra.keys() - {format_.value}) for extra in extras)
