"""A robot on a row of vertices, and the problems that are found with a request to it."""

from itertools import pairwise

from fleet_tui.commands.checks import problems
from fleet_tui.model.commands import Command
from fleet_tui.model.events import CargoReported, Event, GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, link_up, pose, queue, reduced, tick

F1 = "floor_1"


def ready(*facts: Event, floors: int = 1) -> FleetState:
    """robot_0 online at vertex 1 of floor_0, on which 1, 2 and 3 lie in a row."""
    known = (graph(1, 2, 3), labels({1: "Base", 2: "Store"}), queue(T0), CargoReported(R0, T0, False))
    return reduced(fleet(1, floors), link_up(T0), *known, pose(T0), *facts, tick(T0 + 0.5))


def found(state: FleetState, *commands: Command, **floors: str) -> list[tuple[str, bool]]:
    """The names of the problems, and whether each blocks."""
    request = Request(commands, tuple((name[1:], floor) for name, floor in floors.items()))
    return [(problem.check, problem.blocks) for problem in problems(state, request, Permissions())]


def floor(*ids: int, lift: int | None = None, joined: bool = True) -> GraphReceived:
    """floor_1: vertices in a row, one of which may be the elevator."""
    roles = {id_: Role.ELEVATOR if id_ == lift else Role.PLAIN for id_ in ids}
    vertices = {str(id_): Vertex(str(id_), float(n), 0.0, roles[id_]) for n, id_ in enumerate(ids)}
    edges = tuple(Edge(str(n), *pair) for n, pair in enumerate(pairwise(vertices)) if joined)
    return GraphReceived(R0, F1 if 10 in ids else F0, RouteGraph(vertices, edges))
