"""The steps of a graph editor, as changes of a draft."""

from collections.abc import Iterable

from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import Change
from fleet_tui.model.order import natural
from fleet_tui.text.language import Message

GRIDS = (0.01, 0.05, 0.1, 0.25, 0.5, 1.0)
"""Metres of the grids that coordinates are rounded to."""


def added(vertex: DocumentVertex) -> Change:
    return Change(Message("add vertex {id}", id=vertex.id), ((None, vertex),))


def renewed(before: DocumentVertex, after: DocumentVertex) -> Change:
    """Change a vertex: its place, label, type or heading."""
    return Change(Message("change vertex {id}", id=before.id), ((before, after),))


def removed(floor: DocumentFloor, id_: str) -> Change:
    """Remove a vertex with its edges."""
    edges = tuple((edge, None) for edge in floor.edges.values() if id_ in (edge.start, edge.end))
    return Change(Message("remove vertex {id}", id=id_), ((floor.vertices[id_], None),), edges)


def edge_removed(edge: DocumentEdge) -> Change:
    return Change(Message("remove edge {id}", id=edge.id), edges=((edge, None),))


def edge_renewed(before: DocumentEdge, after: DocumentEdge, what: Message) -> Change:
    """Change a value of an edge; `what` says which."""
    return Change(Message("edge {id}: {what}", id=before.id, what=what), edges=((before, after),))


def connected(id_: str, reverse_id: str, start: str, end: str) -> Change:
    """Add an edge, drivable both ways, with an id for each."""
    edge = DocumentEdge(id_, start, end, reverse_id=reverse_id)
    return Change(Message("add edge {start} - {end}", start=start, end=end), edges=((None, edge),))


def joined(one: Change, other: Change) -> Change:
    """Return two changes as one step."""
    return Change(other.text, one.vertices + other.vertices, one.edges + other.edges)


def edge_between(floor: DocumentFloor, one: str, other: str) -> DocumentEdge | None:
    """Return the first edge between two vertices, in any direction."""
    ends = {one, other}
    return next((edge for edge in floor.edges.values() if {edge.start, edge.end} == ends), None)


def turned(edge: DocumentEdge) -> Change:
    """Give an edge its next direction: both ways, from the lower to the higher id, back."""
    if edge.two_way:
        low = edge if natural(edge.start) <= natural(edge.end) else _swapped(edge)
        after = replace(low, two_way=False)
    elif natural(edge.start) <= natural(edge.end):
        after = _swapped(edge)
    else:
        after = replace(_swapped(edge), two_way=True)
    ways = (
        Message("both ways")
        if after.two_way
        else Message("{start} -> {end}", start=after.start, end=after.end)
    )
    return edge_renewed(edge, after, ways)


def _swapped(edge: DocumentEdge) -> DocumentEdge:
    return replace(edge, start=edge.end, end=edge.start, control_points=edge.control_points[::-1])


def snapped(floor: DocumentFloor, x: float, y: float, near: float) -> tuple[float, float]:
    """Return a place in line with a vertex, in each direction that has one within `near` metres; else on the
    grid that fits to that distance."""
    step = max((grid for grid in GRIDS if grid <= near), default=GRIDS[0])
    return (
        _in_line(x, (vertex.x for vertex in floor.vertices.values()), near, step),
        _in_line(y, (vertex.y for vertex in floor.vertices.values()), near, step),
    )


def vertex_there(floor: DocumentFloor, x: float, y: float) -> str:
    """Return the id of a vertex at exactly this place, empty for none: two at one place are told apart by
    nobody."""
    return next((id_ for id_, one in floor.vertices.items() if (one.x, one.y) == (x, y)), "")


def _in_line(value: float, others: Iterable[float], near: float, step: float) -> float:
    low, high = value - near, value + near
    in_line = [other for other in others if low <= other <= high]
    if in_line:
        return min(in_line, key=lambda other: abs(other - value))
    # Multiples of 0.1 are written as such: 0.3, not 0.30000000000000004.
    return round(round(value / step) * step, 6)
