"""Buildings of Open-RMF's traffic editor, to be read: pixels of a drawing, y down, become metres."""

import math
from collections.abc import Iterator
from typing import Any

from msgspec import Struct

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, MissingChoiceError, ReadChoices
from fleet_tui.maps.formats.rmf import flagged
from fleet_tui.maps.formats.yaml_text import settled
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    Motion,
    Stop,
)
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message

FASTEST = 1e6
"""Metres per second; a larger limit is none."""
OTHERS = ("walls", "doors", "models", "floors", "measurements", "layers", "features", "holes")
_IMAGE = "reference_image"
_ON_EARTH = ("wgs84", "web_mercator")
"""Systems of degrees, and of metres that are longer the farther from the equator."""
_MOTIONS = {"forward": Motion.FORWARD, "backward": Motion.BACKWARD}
Levels = dict[str, Table]


class Placing(Struct, frozen=True):
    """The placing of a level's pixels: a turn and scale, then a move, as complex numbers; y up if flipped."""

    factor: complex = 1.0 + 0.0j
    shift: complex = 0.0j
    flipped: bool = True

    def metres(self, x: float, y: float) -> tuple[float, float]:
        """Return the place of a pixel."""
        found = self.factor * complex(x, -y if self.flipped else y) + self.shift
        return found.real, found.imag


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of one of a building's graphs. Raises GraphError, MissingChoiceError."""
    table = fields.mapping(tree, "file")
    levels = {
        name: fields.mapping(level, f"level {name[:40]}")
        for name, level in fields.optional_mapping(table.get("levels"), "levels").items()
    }
    graph = _chosen(levels, choices.building_graph)
    placings = _placings(table, levels)
    stops = dict[str, list[Stop]]()
    floors = {name: _floor(name, level, graph, placings[name], stops) for name, level in levels.items()}
    lifts = tuple(_lifts(table, placings, stops))
    others = {key: sum(_count(level.get(key)) for level in levels.values()) for key in OTHERS}
    name = fields.optional(dict(table), "name", fields.text, "file") or ""
    document = GraphDocument(name, floors, lifts)
    left_out = {key: count for key, count in others.items() if count}
    return GraphFile(GraphFormat.RMF_BUILDING, document, _notes(table, levels), left_out)


def _count(value: Any) -> int:
    return len(value) if isinstance(value, list) else 0


def _params(value: Any, where: str) -> Table:
    """Return parameters, each written as its type's number and the value, or as the value alone, without the
    types."""
    found = {}
    for key, one in fields.optional_mapping(value, where).items():
        if not isinstance(one, list):
            found[key] = settled(one)
            continue
        parts = fields.elements(one, f"{where} {key[:40]}", 2)
        if len(parts) != 2:
            raise GraphError(Message("{where} {key}: must be [type, value]", where=where, key=key[:40]))
        # Type 1 is text, whatever it looks like.
        found[key] = str(parts[1]) if settled(parts[0]) == 1 else settled(parts[1])
    return found


def _lanes(name: str, level: Table) -> Iterator[tuple[int, int, int, Table]]:
    """Yield number, ends and parameters of each lane of a level."""
    size = len(fields.vertex_elements(level.get("vertices"), f"level {name[:40]} vertices"))
    for n, lane in enumerate(fields.edge_elements(level.get("lanes"), f"level {name[:40]} lanes")):
        where = f"level {name[:40]} lane {n}"
        parts = fields.elements(lane, where, 3)
        if len(parts) < 2:
            raise GraphError(Message("{where}: must be a list of three parts", where=where))
        start, end = (fields.index(part, size, where) for part in parts[:2])
        yield n, start, end, _params(parts[2], where) if len(parts) > 2 else {}


def _graph_of(params: Table) -> int:
    found = params.get("graph_idx", 0)
    return found if isinstance(found, int) else -1


def _chosen(levels: Levels, wanted: int | None) -> int:
    """Return the graph to read: the wanted one, or the only one."""
    there = sorted({_graph_of(lane[3]) for name, level in levels.items() for lane in _lanes(name, level)})
    numbers = tuple(str(one) for one in there)
    if wanted is not None:
        if there and wanted not in there:
            raise GraphError(
                Message(
                    "no graph {wanted} in the building: it has {numbers}",
                    wanted=wanted,
                    numbers=", ".join(numbers),
                )
            )
        return wanted
    if len(there) > 1:
        text = Message("the building has the graphs {numbers}: choose one", numbers=", ".join(numbers))
        raise MissingChoiceError(text, "--building-graph", numbers)
    return there[0] if there else 0


def _place(part: Any, where: str) -> tuple[float, float]:
    parts = fields.elements(part, where, 5)
    if len(parts) < 2:
        raise GraphError(Message("{where}: must begin with x and y", where=where))
    return fields.number(parts[0], where), fields.number(parts[1], where)


def _scale(name: str, level: Table) -> float:
    """Return the metres per pixel that a level's measurements say on average, 0 without any."""
    where = f"level {name[:40]}"
    vertices = fields.vertex_elements(level.get("vertices"), f"{where} vertices")
    found = []
    for n, part in enumerate(fields.elements(level.get("measurements"), f"{where} measurements", 1000)):
        at = f"{where} measurement {n}"
        parts = fields.elements(part, at, 3)
        if len(parts) < 3:
            raise GraphError(Message("{at}: must be a list of three parts", at=at))
        ends = [_place(vertices[fields.index(one, len(vertices), at)], at) for one in parts[:2]]
        metres = fields.number(_params(parts[2], at).get("distance"), f"{at} distance")
        pixels = math.dist(*ends)
        if not (pixels > 0 and 0 < metres < math.inf):
            raise GraphError(
                Message(
                    "{at}: {metres} m over {pixels} pixels gives no scale",
                    at=at,
                    metres=f"{metres:g}",
                    pixels=f"{pixels:g}",
                )
            )
        found.append(metres / pixels)
    return sum(found) / len(found) if found else 0.0


def _placings(table: Table, levels: Levels) -> dict[str, Placing]:
    """Return the placing of each level: the reference level by its measurements, the others by the fiducials
    that they share with it, or by their own measurements."""
    system = table.get("coordinate_system", _IMAGE)
    if system in _ON_EARTH:
        raise GraphError(
            Message(
                "coordinate_system {system}: no metres of a floor: export the navigation graph", system=system
            )
        )
    if system != _IMAGE:
        return {name: Placing(flipped=False) for name in levels}
    reference = table.get("reference_level_name", next(iter(levels), ""))
    reference = reference if reference in levels else next(iter(levels), "")
    found = {name: Placing(complex(_scale(name, level) or 1.0)) for name, level in levels.items()}
    known = _fiducials(reference, levels[reference]) if levels else {}
    for name, level in levels.items():
        shared = [(at, known[key]) for key, at in _fiducials(name, level).items() if key in known]
        if name != reference and len(shared) > 1:
            found[name] = _fitted(shared, found[reference], name)
    return found


def _fiducials(name: str, level: Table) -> dict[str, complex]:
    """Return the named points of a level in its pixels, y up."""
    found = {}
    for n, part in enumerate(fields.elements(level.get("fiducials"), f"level {name[:40]} fiducials", 1000)):
        where = f"level {name[:40]} fiducial {n}"
        x, y = _place(part, where)
        if len(part) > 2 and (key := fields.text(part[2], where)):
            found[key] = complex(x, -y)
    return found


def _fitted(shared: list[tuple[complex, complex]], reference: Placing, name: str) -> Placing:
    """Return the placing that brings points onto those of the reference level, best by least squares."""
    points = [one for one, _ in shared]
    targets = [reference.factor * other for _, other in shared]
    middle, target = sum(points) / len(points), sum(targets) / len(targets)
    spread = sum(abs(point - middle) ** 2 for point in points)
    if not (0.0 < spread < math.inf):
        raise GraphError(Message("level {name}: its fiducials are all at one point", name=name[:40]))
    turned = sum(
        (point - middle).conjugate() * (other - target) for point, other in zip(points, targets, strict=True)
    )
    factor = turned / spread
    return Placing(factor, target - factor * middle)


def _floor(
    name: str, level: Table, graph: int, placing: Placing, stops: dict[str, list[Stop]]
) -> DocumentFloor:
    lanes = [lane for lane in _lanes(name, level) if _graph_of(lane[3]) == graph]
    used = {end for _, *ends, _ in lanes for end in ends}
    parts = fields.vertex_elements(level.get("vertices"), f"level {name[:40]} vertices")
    vertices = {}
    for n in sorted(used):
        vertices[str(n)], lift = _vertex(n, parts[n], placing, f"level {name[:40]} vertex {n}")
        if lift:
            stops.setdefault(lift, []).append((name, str(n)))
    edges = {str(n): _edge(n, str(start), str(end), params) for n, start, end, params in lanes}
    return DocumentFloor(name, vertices, edges)


def _vertex(n: int, part: Any, placing: Placing, where: str) -> tuple[DocumentVertex, str]:
    """Return a vertex and the lift whose cabin it is in."""
    parts = fields.elements(part, where, 5)
    x, y = placing.metres(*_place(parts, where))
    # Height, label and parameters; some files lack the height.
    more = list(parts[2:])
    params = _params(more.pop(), where) if more and isinstance(more[-1], dict) else {}
    if more and isinstance(settled(more[0]), int | float):
        more.pop(0)
    label = fields.text(more[0], where) if more else ""
    if len(more) > 1:
        raise GraphError(Message("{where}: must be x, y, height, label and parameters", where=where))
    lift = str(params.get("lift_cabin") or "")
    kind = "lift" if lift else flagged(params)
    kind = kind or ("dock" if params.get("dock_name") else "")
    kind = kind or ("cleaning_zone" if params.get("is_cleaning_zone") is True else "")
    return DocumentVertex(str(n), x, y, label, kind), lift


def _edge(n: int, start: str, end: str, params: Table) -> DocumentEdge:
    speed, motion = params.get("speed_limit"), params.get("orientation")
    return DocumentEdge(
        str(n),
        start,
        end,
        two_way=params.get("bidirectional") is True,
        speed=float(speed) if isinstance(speed, int | float) and 0 < speed < FASTEST else None,
        motion=_MOTIONS.get(motion, Motion.ANY) if isinstance(motion, str) else Motion.ANY,
    )


def _lifts(table: Table, placings: dict[str, Placing], stops: dict[str, list[Stop]]) -> Iterator[Lift]:
    cabins = fields.optional_mapping(table.get("lifts"), "lifts")
    for name in dict.fromkeys([*cabins, *stops]):
        where, at = f"lift {name[:40]}", tuple(stops.get(name, ()))
        cabin = dict(fields.optional_mapping(cabins.get(name), where))
        x, y, yaw, width, depth = (
            fields.optional(cabin, key, fields.number, where) for key in ("x", "y", "yaw", "width", "depth")
        )
        reference = placings.get(
            str(cabin.get("reference_floor_name")), next(iter(placings.values()), Placing())
        )
        place = reference.metres(x, y) if x is not None and y is not None else (0.0, 0.0)
        size = (width, depth) if width is not None and depth is not None else None
        yield Lift(name, at, *place, yaw or 0.0, size)


def _notes(table: Table, levels: Levels) -> tuple[str, ...]:
    if table.get("coordinate_system", _IMAGE) != _IMAGE:
        return ()
    bare = [
        name for name, level in levels.items() if not level.get("measurements") and not level.get("fiducials")
    ]
    return tuple(f"level {name}: no measurement, so a pixel passes as a metre" for name in bare)
