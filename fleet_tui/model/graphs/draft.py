"""The draft of a floor's graph: a series of changes, each of which can be undone."""

from collections.abc import Mapping
from typing import TypeVar

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex, next_id

VertexPair = tuple[DocumentVertex | None, DocumentVertex | None]
EdgePair = tuple[DocumentEdge | None, DocumentEdge | None]


class Change(Struct, frozen=True):
    """One step of an editor: each element before and after it, None for one that does not exist then."""

    text: str
    vertices: tuple[VertexPair, ...] = ()
    edges: tuple[EdgePair, ...] = ()

    @property
    def undone(self) -> "Change":
        """Return the step back."""
        return Change(
            self.text,
            tuple((after, before) for before, after in self.vertices),
            tuple((after, before) for before, after in self.edges),
        )


class GraphDraft:
    """The floor as drawn so far, its steps, and the steps that were undone.

    Ids of removed elements are not given again: orders and other files may still have them.
    """

    def __init__(self, base: DocumentFloor) -> None:
        self.base = self.floor = base
        self.done: list[Change] = []
        self.undone: list[Change] = []
        self._ids = {*base.vertices}
        self._edge_ids = {*base.edges, *(edge.reverse_id for edge in base.edges.values() if edge.reverse_id)}

    @property
    def vertex_id(self) -> str:
        """Return the id of a new vertex. Never 0, which some robots take for a missing value."""
        return next_id(self._ids, "0")

    @property
    def edge_id(self) -> str:
        """Return the id of a new edge."""
        return next_id(self._edge_ids, "0")

    def do(self, change: Change) -> None:
        """Take a step; steps that were undone are gone."""
        self.undone.clear()
        self._take(change)

    def undo(self) -> Change | None:
        """Take the last step back and return it, None if there is none."""
        if not self.done:
            return None
        change = self.done.pop()
        self.undone.append(change)
        self.floor = changed(self.floor, change.undone)
        return change

    def redo(self) -> Change | None:
        """Take the step again that was undone last, and return it."""
        if not self.undone:
            return None
        change = self.undone.pop()
        self._take(change)
        return change

    def _take(self, change: Change) -> None:
        self.done.append(change)
        self.floor = changed(self.floor, change)
        self._ids.update(vertex.id for _, vertex in change.vertices if vertex is not None)
        self._edge_ids.update(edge.id for _, edge in change.edges if edge is not None)


def changed(floor: DocumentFloor, change: Change) -> DocumentFloor:
    """Return the floor after a change."""
    return replace(
        floor,
        vertices=_changed(floor.vertices, change.vertices) if change.vertices else floor.vertices,
        edges=_changed(floor.edges, change.edges) if change.edges else floor.edges,
    )


_Element = TypeVar("_Element", DocumentVertex, DocumentEdge)


def _changed(
    elements: Mapping[str, _Element], pairs: tuple[tuple[_Element | None, _Element | None], ...]
) -> dict[str, _Element]:
    result = dict(elements)
    for before, after in pairs:
        if after is not None:
            result[after.id] = after
        elif before is not None:
            result.pop(before.id, None)
    return result
