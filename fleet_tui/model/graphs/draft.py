"""The draft of a floor's graph: a series of changes, each of which can be undone."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import count
from typing import TypeVar

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.ids import next_id
from fleet_tui.text.language import Message

VertexPair = tuple[DocumentVertex | None, DocumentVertex | None]
EdgePair = tuple[DocumentEdge | None, DocumentEdge | None]


class Change(Struct, frozen=True):
    """One step of an editor: each element before and after it, None for one that does not exist then."""

    text: Message
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
        self._free = int(next_id(base.vertices, _edge_ids(base.edges.values()), "0"))
        """One number for vertices and edges, as some formats want it. Never 0, which some robots take for a
        missing value."""

    def free_ids(self) -> Iterator[str]:
        """Yield ids for new elements, beyond all that the draft has or had."""
        return map(str, count(self._free))

    def do(self, change: Change) -> None:
        """Take a step; steps that were undone are gone."""
        self.undone.clear()
        self._take(change)

    def undo(self) -> Change | None:
        """Take the last step back and return it, None at the beginning."""
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
        made = [vertex.id for _, vertex in change.vertices if vertex is not None]
        drawn = [edge for _, edge in change.edges if edge is not None]
        self._free = max(self._free, int(next_id(made, _edge_ids(drawn))))


def _edge_ids(edges: Iterable[DocumentEdge]) -> Iterator[str]:
    for edge in edges:
        yield from (edge.id, edge.reverse_id)


def changed(floor: DocumentFloor, change: Change) -> DocumentFloor:
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
