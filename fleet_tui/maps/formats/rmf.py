"""Navigation graphs of Open-RMF: YAML, metres, one frame for all floors, lanes in one direction."""

from collections.abc import Iterator
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices, WriteChoices
from fleet_tui.maps.formats.purposes import Purpose, purpose_of
from fleet_tui.maps.formats.site_frame import in_site
from fleet_tui.maps.formats.yaml_text import flow, key_text, settled
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    Motion,
    Stop,
    merge_opposites,
    one_way_edges,
)
from fleet_tui.model.graphs.ids import is_number
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message

OWN = GraphFormat.RMF.value
FLAGS = {
    "is_charger": Purpose.CHARGER,
    "is_parking_spot": Purpose.PARKING,
    "is_holding_point": Purpose.HOLDING,
    "is_passthrough_point": Purpose.PASSTHROUGH,
}
TYPES = {
    Purpose.CHARGER: "charger",
    Purpose.PARKING: "parking_spot",
    Purpose.HOLDING: "holding_point",
    Purpose.PASSTHROUGH: "passthrough_point",
}
UNNAMED = "<Unnamed>"
"""What rmf_site writes for the name of a place without one."""
_MOTIONS = {"forward": Motion.FORWARD, "backward": Motion.BACKWARD}


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file. Raises GraphError."""
    table = dict(fields.mapping(tree, "file"))
    name = fields.optional(table, "building_name", fields.text, "file") or ""
    levels = fields.optional_mapping(table.pop("levels", None), "levels")
    cabins = fields.optional_mapping(table.pop("lifts", None), "lifts")
    stops: dict[str, list[Stop]] = {lift: [] for lift in cabins}
    floors = {level: _floor(level, value, stops) for level, value in levels.items()}
    lifts = tuple(_lift(lift, cabins.get(lift), tuple(at)) for lift, at in stops.items())
    document = GraphDocument(name, floors, lifts, extra=fields.rest(OWN, table))
    return GraphFile(GraphFormat.RMF, document)


def _floor(level: str, value: Any, stops: dict[str, list[Stop]]) -> DocumentFloor:
    where = f"level {level[:40]}"
    table = dict(fields.mapping(value, where))
    parts = fields.vertex_elements(table.pop("vertices", None), f"{where} vertices")
    vertices = dict[str, DocumentVertex]()
    for n, part in enumerate(parts):
        vertices[str(n)], lift = _vertex(n, part, f"{where} vertex {n}")
        if lift:
            stops.setdefault(lift, []).append((level, str(n)))
    lanes = fields.edge_elements(table.pop("lanes", None), f"{where} lanes")
    edges = merge_opposites(_edge(n, lane, len(parts), f"{where} lane {n}") for n, lane in enumerate(lanes))
    return DocumentFloor(level, vertices, edges, extra=fields.rest(OWN, table))


def _parts(value: Any, where: str) -> tuple[Any, Any, Table]:
    """Return the first two parts of a list and its options, which may be missing."""
    parts = fields.elements(value, where, 3)
    if len(parts) < 2:
        raise GraphError(Message("{where}: must be a list of three parts", where=where))
    return parts[0], parts[1], dict(fields.optional_mapping(parts[2], where)) if len(parts) > 2 else {}


def _vertex(n: int, part: Any, where: str) -> tuple[DocumentVertex, str]:
    first, second, options = _parts(part, where)
    x, y = fields.number(first, where), fields.number(second, where)
    label = fields.optional(options, "name", fields.text, where) or ""
    label = "" if label == UNNAMED else label
    lift = fields.optional(options, "lift", fields.text, where) or ""
    type_ = "lift" if lift else flagged(settled(options))
    return DocumentVertex(str(n), x, y, label, type_, extra=fields.rest(OWN, options)), lift


def flagged(options: Table) -> str:
    """Return the type that the flags of a vertex say; the first of several."""
    return next((TYPES[purpose] for key, purpose in FLAGS.items() if options.get(key) is True), "")


def _edge(n: int, part: Any, size: int, where: str) -> DocumentEdge:
    first, second, options = _parts(part, where)
    start, end = fields.index(first, size, where), fields.index(second, size, where)
    speed = fields.optional(options, "speed_limit", fields.number, where)
    motion = Motion.ANY
    if options.get("orientation_constraint") in _MOTIONS:
        motion = _MOTIONS[options.pop("orientation_constraint")]
    return DocumentEdge(
        str(n),
        str(start),
        str(end),
        two_way=False,
        speed=speed if speed is not None and speed > 0 else None,
        motion=motion,
        extra=fields.rest(OWN, options),
    )


def _lift(name: str, value: Any, stops: tuple[Stop, ...]) -> Lift:
    if value is None:
        return Lift(name, stops)
    where = f"lift {name[:40]}"
    table = dict(fields.mapping(value, where))
    x, y, yaw = fields.optional(table, "position", fields.place, where) or (0.0, 0.0, 0.0)
    sides = [fields.number(one, where) for one in fields.elements(table.pop("dims", None), where, 2)]
    size = (sides[0], sides[1]) if len(sides) == 2 else None
    return Lift(name, stops, x, y, yaw, size, fields.rest(OWN, table))


def write(document: GraphDocument, choices: WriteChoices) -> str:
    return "\n".join([*_lines(document), ""])


def _lines(document: GraphDocument) -> Iterator[str]:
    yield f"building_name: {flow(document.name or 'building')}"
    yield "levels:"
    lifts = {stop: lift.name for lift in document.lifts for stop in lift.stops}
    for floor in document.floors.values():
        yield f"  {key_text(floor.name)}:"
        yield from _level(in_site(floor), lifts)
    cabins = _cabins(document)
    yield "lifts:" if cabins else "lifts: {}"
    yield from (f"  {key_text(name)}: {flow(cabin)}" for name, cabin in cabins.items())
    more = document.extra.get(OWN, {})
    yield from (f"{key_text(key)}: {flow(value)}" for key, value in more.items())


def _level(floor: DocumentFloor, lifts: dict[Stop, str]) -> Iterator[str]:
    numbers = {id_: n for n, id_ in enumerate(floor.vertices)}
    ways = one_way_edges(floor.edges.values(), floor.edges)
    if all(is_number(way.id) for way in ways):
        ways.sort(key=lambda way: int(way.id))  # as in the file that they came from
    yield "    lanes:" if ways else "    lanes: []"
    for way in ways:
        yield f"    - [{numbers[way.start]}, {numbers[way.end]}, {flow(_lane(way))}]"
    yield "    vertices:" if floor.vertices else "    vertices: []"
    for id_, vertex in floor.vertices.items():
        options = options_of(vertex, lifts.get((floor.name, id_), ""))
        yield f"    - [{flow(float(vertex.x))}, {flow(float(vertex.y))}, {flow(options)}]"
    yield from (f"    {key_text(key)}: {flow(value)}" for key, value in floor.extra.get(OWN, {}).items())


def _lane(edge: DocumentEdge) -> Table:
    options = dict(edge.extra.get(OWN, {}))
    options |= {"speed_limit": float(edge.speed)} if edge.speed is not None else {}
    return options | ({"orientation_constraint": edge.motion.value} if edge.motion is not Motion.ANY else {})


def options_of(vertex: DocumentVertex, lift: str = "") -> Table:
    """Return the options of a vertex: those of the file, with the flag of its type as it is now."""
    options = dict(vertex.extra.get(OWN, {}))
    purpose = purpose_of(vertex.type)
    if not lift and purpose_of(flagged(options)) is not purpose:
        options = {key: value for key, value in options.items() if key not in FLAGS}
        options |= {key: True for key, one in FLAGS.items() if one is purpose}
    return {"name": vertex.label, **options, **({"lift": lift} if lift else {})}


def _cabins(document: GraphDocument) -> dict[str, Table]:
    """Return the table of lifts: with all of them or none, as a lift outside the table is refused."""
    if not any(lift.size or lift.extra.get(OWN) for lift in document.lifts):
        return {}
    return {lift.name: _cabin(lift, document) for lift in document.lifts}


def _cabin(lift: Lift, document: GraphDocument) -> Table:
    places = [
        (vertex.x, vertex.y)
        for floor, id_ in lift.stops
        if floor in document.floors and (vertex := in_site(document.floors[floor]).vertices.get(id_))
    ]
    x, y = (lift.x, lift.y) if lift.size or not places else places[0]
    return {"position": [x, y, lift.yaw], "dims": list(lift.size or (1.0, 1.0)), **lift.extra.get(OWN, {})}
