"""The simulator's own route graph: the shortest way, both ways along each edge."""

from fleet_tui.simulator.warehouse import SimEdge, SimGraph, SimVertex

SPOTS = {1: (0.0, 0.0), 2: (1.0, 0.0), 3: (1.0, 1.0), 4: (9.0, 9.0)}
GRAPH = SimGraph(
    {id_: SimVertex(id_, *spot) for id_, spot in SPOTS.items()},
    (SimEdge(0, 1, 2), SimEdge(1, 2, 3), SimEdge(2, 4, 4)),
)


def test_the_way_leads_along_edges_in_both_directions() -> None:
    assert GRAPH.path(1, 3) == (1, 2, 3) and GRAPH.path(3, 1) == (3, 2, 1)
    assert GRAPH.path(2, 2) == (2,) and GRAPH.path(1, 4) == ()


def test_the_shorter_of_two_ways_is_taken_however_many_corners_it_has() -> None:
    detour = SimGraph(
        {**GRAPH.vertices, 5: SimVertex(5, -50.0, 0.0)}, (*GRAPH.edges, SimEdge(3, 1, 5), SimEdge(4, 5, 3))
    )
    assert detour.path(1, 3) == (1, 2, 3)
