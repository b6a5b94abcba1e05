"""Robots on a street with a way around one of its edges."""

from fleet_tui.model.events import Event, GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from tests.support.fleets import F0, T0, fleet, link_up, reduced, tick

PLACES = {1: (0.0, 0.0), 2: (10.0, 0.0), 3: (20.0, 0.0), 4: (10.0, 5.0), 5: (30.0, 0.0)}
"""A street 1 - 2 - 3 - 5, and a way around 2 - 3 by 4."""
WAYS = ((1, 2), (2, 3), (3, 5), (2, 4), (4, 3))
AROUND = 2 * (5.0**2 + 10.0**2) ** 0.5 / 2 + 5.0


def street(robot: str, directed: bool = False) -> GraphReceived:
    vertices = {str(n): Vertex(str(n), *at) for n, at in PLACES.items()}
    edges = tuple(Edge(f"{a}{b}", str(a), str(b)) for a, b in WAYS)
    return GraphReceived(robot, F0, RouteGraph(vertices, edges, directed))


def fleet_with(*facts: Event, robots: int = 2, directed: bool = False) -> FleetState:
    names = [f"robot_{n}" for n in range(robots)]
    graphs = [street(name, directed) for name in names]
    return reduced(fleet(robots), link_up(T0), *graphs, *facts, tick(T0 + 1))
