"""Whole numbers as ids, for formats that take no others. Ids that fit are kept: orders name them."""

from collections.abc import Collection, Iterable

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor
from fleet_tui.model.graphs.ids import is_number


class Numbered(Struct, frozen=True):
    """A floor with numbers as ids. vertices, edges: how many have another id than before."""

    floor: DocumentFloor
    vertices: int = 0
    edges: int = 0


def numbered(floor: DocumentFloor, lowest: int = -(2**31), one_counter: bool = False) -> Numbered:
    """Return a floor in which all ids are whole numbers from `lowest` on.

    one_counter: vertices and edges share no id. A reverse direction's id is forgotten if it does not fit.
    """
    vertices = _new_ids(floor.vertices, lowest, ())
    taken = set(vertices.values()) if one_counter else set[str]()
    # With one counter new ids of edges are above those of all vertices.
    edges = _new_ids(floor.edges, lowest, taken)
    used = taken | set(edges.values())
    renamed = {
        vertices[id_]: replace(
            vertex, id=vertices[id_], source_id=_source(id_, vertices[id_], vertex.source_id)
        )
        for id_, vertex in floor.vertices.items()
    }
    ways = [_renamed(edge, edges[id_], vertices, used, lowest) for id_, edge in floor.edges.items()]
    return Numbered(
        replace(floor, vertices=renamed, edges={way.id: way for way in ways}),
        sum(old != new for old, new in vertices.items()),
        sum(old != new for old, new in edges.items()),
    )


def _source(old: str, new: str, before: str) -> str:
    return before if old == new or is_number(old) else old


def _fits(id_: str, lowest: int) -> bool:
    return is_number(id_) and int(id_) >= lowest


def _new_ids(ids: Iterable[str], lowest: int, taken: Collection[str]) -> dict[str, str]:
    """Return the new id of each: the old one where it is a free number."""
    wanted = list(ids)
    kept = {id_ for id_ in wanted if _fits(id_, lowest) and id_ not in taken}
    free = max((int(id_) for id_ in (*kept, *taken)), default=-1) + 1
    free = max(free, lowest, 0)
    found = dict[str, str]()
    for id_ in wanted:
        found[id_] = id_ if id_ in kept else str(free)
        free += id_ not in kept
    return found


def _renamed(
    edge: DocumentEdge, id_: str, vertices: dict[str, str], used: set[str], lowest: int
) -> DocumentEdge:
    back = edge.reverse_id
    if back in used or not _fits(back, lowest):
        back = ""
    used.add(back)
    # An end that names no vertex stays as it is, for lint to find.
    start, end = (vertices.get(one, one) for one in (edge.start, edge.end))
    source = _source(edge.id, id_, edge.source_id)
    return replace(edge, id=id_, reverse_id=back, start=start, end=end, source_id=source)
