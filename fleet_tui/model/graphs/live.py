"""Between the graph that robots drive on and the floor of a document."""

from collections.abc import Callable, Mapping

from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    merge_opposites,
    one_way_edges,
)
from fleet_tui.model.graphs.ids import distinct

ROLES: Mapping[str, Role] = {
    "elevator": Role.ELEVATOR,
    "lift": Role.ELEVATOR,
    "charger": Role.DOCKING,
    "charging_station": Role.DOCKING,
    "dock": Role.DOCKING,
    "docking": Role.DOCKING,
    "docking_station": Role.DOCKING,
}
"""Roles by the type of a vertex, where no profile says otherwise; all others are plain."""


def role_of(type_: str) -> Role:
    """Return the usual role of a vertex of this type."""
    return ROLES.get(type_, Role.PLAIN)


def roles_of(graph: RouteGraph | None) -> Callable[[str], Role]:
    """Return a function from types to roles: as the robots' graph has them, else the usual ones."""
    known = {vertex.type: vertex.role for vertex in graph.vertices.values()} if graph is not None else {}
    return lambda type_: known.get(type_) or role_of(type_)


def route_graph(
    floor: DocumentFloor, roles: Callable[[str], Role] = role_of
) -> tuple[RouteGraph, dict[str, str]]:
    """Return the graph that robots drive on, and its labels by vertex id.

    Locked edges are left out, and those to unknown vertices. Where one edge leads one way only, the graph is
    directed, and the others are in it twice.
    """
    vertices = {id_: Vertex(id_, v.x, v.y, roles(v.type), v.type) for id_, v in floor.vertices.items()}
    usable = [
        edge
        for edge in floor.edges.values()
        if not edge.locked and edge.start in vertices and edge.end in vertices
    ]
    if all(edge.two_way for edge in usable):
        return RouteGraph(
            vertices, tuple(Edge(e.id, e.start, e.end, e.reverse_id) for e in usable)
        ), floor.labels
    ways = one_way_edges(usable, floor.edges)
    return RouteGraph(vertices, tuple(Edge(w.id, w.start, w.end) for w in ways), True), floor.labels


def floor_of(name: str, graph: RouteGraph, labels: Mapping[str, str], frame_id: str = "") -> DocumentFloor:
    """Return a live graph as the floor of a document: its vertices keep the robot stack's own types."""
    vertices = {
        id_: DocumentVertex(id_, v.x, v.y, labels.get(id_, ""), v.type or _word(v.role))
        for id_, v in graph.vertices.items()
    }
    ids = distinct(edge.id for edge in graph.edges)
    edges = [
        DocumentEdge(id_, edge.start, edge.end, not graph.directed, edge.reverse_id)
        for (id_, _), edge in zip(ids, graph.edges, strict=True)
    ]
    return DocumentFloor(name, vertices, merge_opposites(edges), frame_id or name)


def _word(role: Role) -> str:
    return "" if role is Role.PLAIN else role.value
