"""Tests of orders/masters."""

from fleet_tui.commands.checks import problems
from fleet_tui.config.load import from_text
from fleet_tui.model import events
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.order import at_vertices
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from tests.support.vda_fleet import ONE, VehicleSite, config_text
from tests.support.vda_messages import node, position, state

TWO = f'{ONE}\n[[robots]]\nname = "other"\nmanufacturer = "KIT"\nserial = "0002"\nlink = "broker"'
PLACES = {"n0": (0.0, 0.0), "n1": (5.0, 0.0), "n2": (9.0, 0.0), "n3": (0.0, 9.0)}
EDGES = (Edge("a", "n0", "n1"), Edge("b", "n1", "n2"), Edge("c", "n0", "n3"))
GRAPH = RouteGraph({id_: Vertex(id_, *place) for id_, place in PLACES.items()}, EDGES)


def warned(goal: str, *left: str) -> list[str]:
    """The warnings of an order to a node, while the other vehicle has these nodes left from n2."""
    site = VehicleSite(from_text(config_text(robots=TWO)))
    site.apply(events.FloorGraphLoaded("hall", GRAPH))
    site.read("state", state(agvPosition=position(0.0, 0.0)))
    nodes = [node(id_, 2 * n) for n, id_ in enumerate(left)]
    other = state(lastNodeId="n2", orderId="o" * bool(left), nodeStates=nodes, agvPosition=position(9.0, 0.0))
    site.read("state", other, base="uagv/v2/KIT/0002")
    site.wait(0.1)
    request = Request((PlaceOrder("agv", at_vertices(goal)),))
    return [one.text for one in problems(site.state, request, Permissions()) if one.check == "shared way"]


def test_an_edge_that_another_vehicle_has_left_is_asked_about() -> None:
    assert warned("n2", "n1") == ["the route of agv shares an edge with other: no traffic control here"]
    assert warned("n3", "n1") == [] and warned("n2") == []
