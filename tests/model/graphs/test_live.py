"""Graphs of robots as drafts, and drafts as graphs of robots."""

from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.live import floor_of, route_graph

VERTICES = {
    "0": Vertex("0", 0.0, 0.0),
    "7": Vertex("7", 0.1234567890123, 2.0, Role.ELEVATOR, "lift"),
    "9": Vertex("9", 1.0, 1.0, Role.DOCKING),
}


def test_a_live_graph_and_back_is_the_same() -> None:
    graph = RouteGraph(VERTICES, (Edge("0", "0", "7"), Edge("3", "7", "9")))
    floor = floor_of("f", graph, {"7": "Up"}, "map")
    assert (floor.name, floor.frame_id, floor.labels) == ("f", "map", {"7": "Up"})
    assert floor.vertices["7"] == DocumentVertex("7", 0.1234567890123, 2.0, "Up", "lift")
    assert floor.vertices["9"].type == "docking"
    again, labels = route_graph(floor)
    assert (again.edges, again.directed, labels) == (graph.edges, False, {"7": "Up"})
    assert [one.role for one in again.vertices.values()] == [Role.PLAIN, Role.ELEVATOR, Role.DOCKING]


def test_in_a_directed_graph_both_ways_are_two_edges() -> None:
    graph = RouteGraph(VERTICES, (Edge("0", "0", "7"), Edge("1", "7", "0"), Edge("2", "7", "9")), True)
    floor = floor_of("f", graph, {})
    assert {id_: edge.two_way for id_, edge in floor.edges.items()} == {"0": True, "2": False}
    again, _ = route_graph(floor)
    assert (again.edges, again.directed) == (graph.edges, True)


def test_of_edges_with_one_id_the_last_keeps_it() -> None:
    floor = floor_of("f", RouteGraph(VERTICES, (Edge("4", "0", "7"), Edge("4", "7", "9"))), {})
    assert {id_: edge.start for id_, edge in floor.edges.items()} == {"5": "0", "4": "7"}


def test_the_id_of_the_way_back_is_kept() -> None:
    floor = floor_of("f", RouteGraph(VERTICES, (Edge("4", "0", "7", "5"),)), {})
    assert floor.edges["4"].reverse_id == "5" and route_graph(floor)[0].edges[0].reverse_id == "5"


def test_locked_and_dangling_edges_are_no_way() -> None:
    vertices = {id_: DocumentVertex(id_, 0.0, 0.0, type="x") for id_ in ("0", "1")}
    edges = {"1": DocumentEdge("1", "0", "1", locked=True), "2": DocumentEdge("2", "0", "8", two_way=False)}
    graph, _ = route_graph(DocumentFloor("f", vertices, edges), lambda _: Role.DOCKING)
    assert graph.edges == () and not graph.directed
    assert graph.vertices["0"].role is Role.DOCKING
