"""Lint of single vertices and edges: ids, places, ends, labels, types."""

import math
from collections.abc import Callable, Iterator

from fleet_tui.features.graphs.rules.finding import GraphFinding, LintInputs
from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import cell_width, sanitize

INT32 = range(-(2**31), 2**31)
FARTHEST = 1e9
"""Metres; a place farther off is on no floor."""
LONGEST_LABEL = 32
"""Terminal cells."""
MOVED = 0.5
"""Metres by which a vertex that an order names may be moved."""
READ_AS_0 = Message("robots read a missing id as 0, that is as this vertex")
_WITH_ZERO = (None, GraphFormat.NATIVE, GraphFormat.OH, GraphFormat.GEOJSON)

ElementRule = Callable[[DocumentFloor, LintInputs], Iterator[GraphFinding]]


def named(vertex: DocumentVertex) -> str:
    """Return a vertex's id with its label."""
    return f"{vertex.id} ({vertex.label})" if vertex.label.strip() else vertex.id


def _error(rule: str, text: Message, vertex: str = "", edge: str = "") -> GraphFinding:
    return _finding(rule, text, True, vertex, edge)


def _warning(rule: str, text: Message, vertex: str = "", edge: str = "") -> GraphFinding:
    return _finding(rule, text, False, vertex, edge)


def _finding(rule: str, text: Message, is_error: bool, vertex: str, edge: str) -> GraphFinding:
    vertices, edges = (tuple(filter(None, [one])) for one in (vertex, edge))
    return GraphFinding(rule, text, is_error, "", vertices, edges)


def duplicate_ids(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report ids that the file had several times, each once."""
    vertices = {repeated: one.id for one in floor.vertices.values() for repeated in one.repeats}
    for repeated, id_ in vertices.items():
        yield _error("duplicate id", Message("vertex {id}: duplicate id", id=repeated), id_)
    edges = {repeated: one.id for one in floor.edges.values() for repeated in one.repeats}
    for repeated, id_ in edges.items():
        yield _error("duplicate id", Message("edge {id}: duplicate id", id=repeated), "", id_)


def _is_too_large(id_: str) -> bool:
    digits = id_.removeprefix("-")
    return digits.isascii() and digits.isdecimal() and (len(digits) > 10 or int(id_) not in INT32)


def large_ids(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report ids that no message can carry."""
    for id_ in filter(_is_too_large, floor.vertices):
        yield _error("id range", Message("vertex {id}: id outside int32", id=id_), id_)
    for id_ in filter(_is_too_large, floor.edges):
        yield _error("id range", Message("edge {id}: id outside int32", id=id_), "", id_)


def ends(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report edges that connect nothing."""
    for id_, edge in floor.edges.items():
        lost = [end for end in (edge.start, edge.end) if end not in floor.vertices]
        if lost:
            yield _error(
                "unknown vertex",
                Message("edge {id}: unknown vertex {vertex}", id=id_, vertex=lost[0]),
                "",
                id_,
            )
        elif edge.start == edge.end:
            yield _error(
                "loop",
                Message("edge {id}: leads from {start} to itself", id=id_, start=edge.start),
                edge.start,
                id_,
            )


def places(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report vertices at no place, or off the map."""
    for id_, vertex in floor.vertices.items():
        if not (abs(vertex.x) <= FARTHEST and abs(vertex.y) <= FARTHEST):
            text = Message(
                "vertex {named}: ({x}, {y}) m is not a place on a floor",
                named=named(vertex),
                x=f"{vertex.x:g}",
                y=f"{vertex.y:g}",
            )
            yield _error("place", text, id_)
        elif inputs.grid is not None and not _is_on(inputs, vertex):
            text = Message(
                "vertex {named}: ({x}, {y}) m is off the map",
                named=named(vertex),
                x=f"{vertex.x:.2f}",
                y=f"{vertex.y:.2f}",
            )
            yield _error("place", text, id_)


def values(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report numbers that can't be: negative speeds, costs and lengths, and those that are not finite."""
    for id_, vertex in floor.vertices.items():
        if vertex.heading is not None and not math.isfinite(vertex.heading):
            yield _error(
                "value",
                Message(
                    "vertex {named}: heading {heading} is not an angle",
                    named=named(vertex),
                    heading=f"{vertex.heading:g}",
                ),
                id_,
            )
    for id_, edge in floor.edges.items():
        numbers = {
            "speed": edge.speed,
            "speed_percent": edge.speed_percent,
            "cost": edge.cost,
            "length": edge.length,
        }
        for name, value in numbers.items():
            if value is not None and not 0.0 <= value < math.inf:
                yield _error(
                    "value",
                    Message(
                        "edge {id}: {name} {value} must be a number from 0 on",
                        id=id_,
                        name=name,
                        value=f"{value:g}",
                    ),
                    "",
                    id_,
                )


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
            yield _error("label", Message("vertex {id}: label is blank", id=id_), id_)
            continue
        if sanitize(label) != label:
            text = Message(
                "vertex {id}: control characters in label {label}", id=id_, label=f"{sanitize(label)!r}"
            )
            yield _error("label", text, id_)
        other = taken.setdefault(folded(label), id_)
        if other != id_:
            yield GraphFinding(
                "label",
                Message(
                    "vertex {id}: label {label} is taken by vertex {other}",
                    id=id_,
                    label=f"{label!r}",
                    other=other,
                ),
                True,
                "",
                (id_, other),
            )
        if cell_width(label) > LONGEST_LABEL:
            text = Message(
                "vertex {id}: label of {cells} cells, over {limit}",
                id=id_,
                cells=cell_width(label),
                limit=LONGEST_LABEL,
            )
            yield _warning("long label", text, id_)


def types(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report types that the profile does not know, and the id that a missing argument would mean."""
    if "0" in floor.vertices and inputs.target in _WITH_ZERO:
        yield _warning(
            "id 0",
            Message("vertex {named}: {problem}", named=named(floor.vertices["0"]), problem=READ_AS_0),
            "0",
        )
    if inputs.types is None:
        return
    for id_, vertex in floor.vertices.items():
        if vertex.type and vertex.type not in inputs.types:
            yield _warning(
                "type",
                Message(
                    "vertex {named}: type {type} unknown to the profile",
                    named=named(vertex),
                    type=f"{vertex.type!r}",
                ),
                id_,
            )


def elevators(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report elevators that lead nowhere."""
    if inputs.elsewhere is None:
        return
    partners = {folded(label) for label in inputs.elsewhere}
    for id_, vertex in floor.vertices.items():
        if inputs.roles(vertex.type) is Role.ELEVATOR and folded(vertex.label) not in partners:
            text = Message("vertex {named}: elevator without a partner on another floor", named=named(vertex))
            yield _warning("elevator", text, id_)


def orders(floor: DocumentFloor, inputs: LintInputs) -> Iterator[GraphFinding]:
    """Report vertices that orders name, and that are removed or moved."""
    live = inputs.live.vertices if inputs.live is not None else {}
    for id_, order in inputs.ordered.items():
        if id_ not in live:
            continue
        now, before = floor.vertices.get(id_), live[id_]
        if now is None:
            yield _error(
                "order", Message("vertex {id} is removed, but {order} names it", id=id_, order=order), id_
            )
            continue
        metres = math.dist((now.x, now.y), (before.x, before.y))
        if not metres <= MOVED:
            yield _error(
                "order",
                Message(
                    "vertex {named} is moved {metres} m, but {order} names it",
                    named=named(now),
                    metres=f"{metres:.2f}",
                    order=order,
                ),
                id_,
            )


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
