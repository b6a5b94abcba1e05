"""The difference of two graphs of a floor, by id."""

import math
from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.features.graphs.rules.elements import named
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor
from fleet_tui.model.order import natural
from fleet_tui.text.language import N_, Message
from fleet_tui.text.sanitize import sanitize

MOVED = 0.01
"""Metres from which a vertex is moved."""


class GraphChange(Struct, frozen=True):
    """One change. kind: added, removed, moved, relabelled, retyped or rewired; ids as in the graph."""

    kind: str
    text: str
    vertex: str = ""
    edge: str = ""


def difference(before: DocumentFloor, after: DocumentFloor) -> tuple[GraphChange, ...]:
    """Return the changes from one graph to another: of vertices, then of edges."""
    found = list[GraphChange]()
    for id_ in sorted({*before.vertices, *after.vertices}, key=natural):
        found += _of_vertex(before, after, id_)
    old, new = _ways(before.edges), _ways(after.edges)
    for id_ in sorted({*old, *new}, key=natural):
        found += _of_edge(old.get(id_), new.get(id_), id_)
    return tuple(found)


def _of_vertex(before: DocumentFloor, after: DocumentFloor, id_: str) -> list[GraphChange]:
    old, new = before.vertices.get(id_), after.vertices.get(id_)
    if old is None or new is None:
        one = new or old
        kind = N_("removed") if new is None else N_("added")
        return [GraphChange(kind, Message("vertex {named}", named=named(one) if one else id_), id_)]
    found = []
    metres = math.dist((old.x, old.y), (new.x, new.y))
    both_nowhere = not math.isfinite(metres) and str((old.x, old.y)) == str((new.x, new.y))
    if not metres <= MOVED and not both_nowhere:
        moved = Message("vertex {named}: {metres} m", named=named(new), metres=f"{metres:.2f}")
        found.append(GraphChange(N_("moved"), moved, id_))
    if old.label != new.label:
        text: str = Message(
            "vertex {id}: {before} -> {after}", id=id_, before=_quoted(old.label), after=_quoted(new.label)
        )
        found.append(GraphChange(N_("relabelled"), text, id_))
    if old.type != new.type:
        text = Message(
            "vertex {named}: {before} -> {after}",
            named=named(new),
            before=old.type or "plain",
            after=new.type or "plain",
        )
        found.append(GraphChange(N_("retyped"), text, id_))
    return found


def _quoted(label: str) -> Message:
    return Message('"{label}"', label=sanitize(label)) if label else Message("no label")


_Way = tuple[str, str, bool]


def _ways(edges: Mapping[str, DocumentEdge]) -> dict[str, _Way]:
    """Return start, end and both-ways of each edge. Its other id is the same edge, and no other one."""
    return {id_: (edge.start, edge.end, edge.two_way) for id_, edge in edges.items()}


def _of_edge(old: _Way | None, new: _Way | None, id_: str) -> list[GraphChange]:
    if old is None or new is None:
        kind, way = (N_("removed"), old) if new is None else (N_("added"), new)
        return (
            [GraphChange(kind, Message("edge {id} {way_text}", id=id_, way_text=_way_text(way)), "", id_)]
            if way
            else []
        )
    if _unordered(old) == _unordered(new):
        return []
    return [
        GraphChange(
            N_("rewired"),
            Message("edge {id}: {before} -> {after}", id=id_, before=_way_text(old), after=_way_text(new)),
            "",
            id_,
        )
    ]


def _unordered(way: _Way) -> tuple[object, bool]:
    """Return a way for comparison: one that leads both ways has no start."""
    return (frozenset(way[:2]) if way[2] else way[:2]), way[2]


def _way_text(way: _Way) -> Message:
    return Message("{start} {direction} {end}", start=way[0], direction="<>" if way[2] else ">", end=way[1])
