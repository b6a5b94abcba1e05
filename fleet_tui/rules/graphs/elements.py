"""Lint of single vertices and edges: ids, places, ends, labels, types."""

import math
from collections.abc import Callable, Iterator

from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat
from fleet_tui.rules.graphs.finding import GraphFinding, LintInputs
from fleet_tui.text.sanitize import cell_width, sanitize

INT32 = range(-(2**31), 2**31)
FARTHEST = 1e9
"""Metres; a place farther off is on no floor."""
LONGEST_LABEL = 32
"""Terminal cells."""
MOVED = 0.5
"""Metres by which a vertex that an order names may be moved."""
READ_AS_0 = "robots read a missing id as 0, that is as this vertex"
_WITH_ZERO = (None, GraphFormat.NATIVE, GraphFormat.OH, GraphFormat.GEOJSON)

ElementRule = Callable[[DocumentFloor, LintInputs], Iterator[GraphFinding]]


def named(vertex: DocumentVertex) -> str:
    """Return a vertex's id with its label."""
    return f"{vertex.id} ({vertex.label})" if vertex.label.strip() else vertex.id


def _error(rule: str, text: str, vertex: str = "", edge: str = "") -> GraphFinding:
    return _finding(rule, text, True, vertex, edge)


def _warning(rule: str, text: str, vertex: str = "", edge: str = "") -> GraphFinding:
    return _finding(rule, text, False, vertex, edge)


def _finding(rule: str, text: str, is_error: bool, vertex: str, edge: str) -> GraphFinding:
    vertices, edges = (tuple(filter(None, [one])) for one in (vertex, edge))
    return GraphFinding(rule, text, is_error, "", vertices, edges)


def duplicate_ids(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report ids that the file had several times, each once."""
    vertices = {repeated: one.id for one in floor.vertices.values() for repeated in one.repeats}
    for repeated, id_ in vertices.items():
        yield _error("duplicate id", f"vertex {repeated}: duplicate id", id_)
    edges = {repeated: one.id for one in floor.edges.values() for repeated in one.repeats}
    for repeated, id_ in edges.items():
        yield _error("duplicate id", f"edge {repeated}: duplicate id", "", id_)


def _is_too_large(id_: str) -> bool:
    digits = id_.removeprefix("-")
    return digits.isascii() and digits.isdecimal() and (len(digits) > 10 or int(id_) not in INT32)


def large_ids(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report ids that no message can carry."""
    for id_ in filter(_is_too_large, floor.vertices):
        yield _error("id range", f"vertex {id_}: id outside int32", id_)
    for id_ in filter(_is_too_large, floor.edges):
        yield _error("id range", f"edge {id_}: id outside int32", "", id_)


def ends(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report edges that connect nothing."""
    for id_, edge in floor.edges.items():
        lost = [end for end in (edge.start, edge.end) if end not in floor.vertices]
        if lost:
            yield _error("unknown vertex", f"edge {id_}: unknown vertex {lost[0]}", "", id_)
        elif edge.start == edge.end:
            yield _error("loop", f"edge {id_}: leads from {edge.start} to itself", edge.start, id_)


def places(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report vertices at no place, or off the map."""
    for id_, vertex in floor.vertices.items():
        if not (abs(vertex.x) <= FARTHEST and abs(vertex.y) <= FARTHEST):
            text = f"vertex {named(vertex)}: ({vertex.x:g}, {vertex.y:g}) m is no place on a floor"
            yield _error("place", text, id_)
        elif inputs.grid is not None and not _is_on(inputs, vertex):
            text = f"vertex {named(vertex)}: ({vertex.x:.2f}, {vertex.y:.2f}) m is off the map"
            yield _error("place", text, id_)


def values(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report numbers that can't be: negative speeds, costs and lengths, and those that are not finite."""
    for id_, vertex in floor.vertices.items():
        if vertex.heading is not None and not math.isfinite(vertex.heading):
            yield _error("value", f"vertex {named(vertex)}: heading {vertex.heading:g} is no angle", id_)
    for id_, edge in floor.edges.items():
        numbers = {
            "speed": edge.speed,
            "speed_percent": edge.speed_percent,
            "cost": edge.cost,
            "length": edge.length,
        }
        for name, value in numbers.items():
            if value is not None and not 0.0 <= value < math.inf:
                yield _error("value", f"edge {id_}: {name} {value:g} must be a number from 0 on", "", id_)


def _is_on(inputs: LintInputs, vertex: DocumentVertex) -> bool:
    assert inputs.grid is not None
    frame = inputs.grid.frame
    column, row = frame.to_pixel(vertex.x, vertex.y)
    return 0 <= column < frame.width and 0 <= row < frame.height


def folded(label: str) -> str:
    """Return a label as it is compared: without case, with single blanks."""
    return " ".join(label.split()).casefold()


def labels(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report labels that can't be typed, shown or told apart."""
    taken = dict[str, str]()
    for id_, label in floor.labels.items():
        if not folded(label):
            yield _error("label", f"vertex {id_}: label of blanks only", id_)
            continue
        if sanitize(label) != label:
            text = f"vertex {id_}: control characters in label {sanitize(label)!r}"
            yield _error("label", text, id_)
        other = taken.setdefault(folded(label), id_)
        if other != id_:
            yield GraphFinding(
                "label", f"vertex {id_}: label {label!r} is taken by vertex {other}", True, "", (id_, other)
            )
        if cell_width(label) > LONGEST_LABEL:
            text = f"vertex {id_}: label of {cell_width(label)} cells, over {LONGEST_LABEL}"
            yield _warning("long label", text, id_)


def types(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report types that the profile does not know, and the id that a missing argument would mean."""
    if "0" in floor.vertices and inputs.target in _WITH_ZERO:
        yield _warning("id 0", f"vertex {named(floor.vertices['0'])}: {READ_AS_0}", "0")
    if inputs.types is None:
        return
    for id_, vertex in floor.vertices.items():
        if vertex.type and vertex.type not in inputs.types:
            yield _warning(
                "type", f"vertex {named(vertex)}: type {vertex.type!r} unknown to the profile", id_
            )


def elevators(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report elevators that lead nowhere."""
    if inputs.elsewhere is None:
        return
    partners = {folded(label) for label in inputs.elsewhere}
    for id_, vertex in floor.vertices.items():
        if inputs.roles(vertex.type) is Role.ELEVATOR and folded(vertex.label) not in partners:
            text = f"vertex {named(vertex)}: elevator without a partner on another floor"
            yield _warning("elevator", text, id_)


def orders(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report vertices that orders name, and that are removed or moved."""
    live = inputs.live.vertices if inputs.live is not None else {}
    for id_, order in inputs.ordered.items():
        if id_ not in live:
            continue
        now, before = floor.vertices.get(id_), live[id_]
        if now is None:
            yield _error("order", f"vertex {id_} is removed, but {order} names it", id_)
            continue
        metres = math.dist((now.x, now.y), (before.x, before.y))
        if not metres <= MOVED:
            yield _error("order", f"vertex {named(now)} is moved {metres:.2f} m, but {order} names it", id_)


ELEMENT_RULES: tuple[ElementRule, ...] = (
    duplicate_ids,
    large_ids,
    ends,
    places,
    values,
    labels,
    orders,
    types,
    elevators,
)
