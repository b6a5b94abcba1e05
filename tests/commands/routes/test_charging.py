"""The nearest charger, and where the way to it begins."""

from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes import charging
from fleet_tui.model import events
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.events import GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.model.vehicles.vehicle import VehicleFeatures
from fleet_tui.text.errors import CommandError
from tests.support.fleets import F0, R0, T0, fleet, pose, reduced
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import position, state

CHARGER, FAR = Vertex("1", 0.0, 0.0, Role.DOCKING), Vertex("3", 40.0, 0.0, Role.DOCKING)
AWAY = GraphReceived(
    R0, F0, RouteGraph({"1": CHARGER, "2": Vertex("2", 5.0, 0.0), "3": FAR}, (Edge("b", "1", "2"),), True)
)
"""The only edge leads from the charger."""


def graph_of(vertices: dict[str, Vertex]) -> GraphReceived:
    return GraphReceived(R0, F0, RouteGraph(vertices))


def at(x: float, graph: GraphReceived) -> FleetState:
    return reduced(fleet(), graph, pose(T0, x))


def way_to_charger(state: FleetState) -> tuple[Place, ...]:
    return charging.way_to_charger(state, state.robots[R0])


def order_to_charger(state: FleetState) -> Request:
    return charging.order_to_charger(state, state.robots[R0])


def test_the_way_to_the_nearest_charger_begins_at_the_vertex_nearest_to_the_robot() -> None:
    graph = graph_of({"1": CHARGER, "2": Vertex("2", 5.0, 0.0), "3": FAR})
    state = at(4.0, graph)
    assert way_to_charger(state) == (Place("2", "2", F0), Place("1", "1", F0))
    assert way_to_charger(at(22.0, graph)) == (Place("2", "2", F0), Place("3", "3", F0))
    assert way_to_charger(at(0.5, graph)) == (), "it is there"
    without = graph_of({"2": Vertex("2", 5.0, 0.0)})
    assert way_to_charger(at(4.0, without)) == ()
    assert way_to_charger(reduced(fleet(), pose(T0))) == ()


def test_a_charger_that_can_not_be_reached_is_none() -> None:
    vertices = {"1": CHARGER, "2": Vertex("2", 5.0, 0.0), "3": FAR}
    there = GraphReceived(R0, F0, RouteGraph(vertices, (Edge("a", "2", "3"), Edge("b", "1", "2")), True))
    assert way_to_charger(at(4.0, there)) == (Place("2", "2", F0), Place("3", "3", F0))
    assert way_to_charger(at(4.0, AWAY)) == ()


def beside(x: float, *vertices: Vertex) -> FleetState:
    """The first robot at 4 m, another one at `x` on the same graph."""
    graph = RouteGraph({one.id: one for one in (Vertex("2", 5.0, 0.0), *vertices)})
    graphs = [GraphReceived(name, F0, graph) for name in (R0, "robot_1")]
    return reduced(fleet(2), *graphs, pose(T0, 4.0), pose(T0, x, robot="robot_1"))


def test_a_charger_that_another_robot_is_at_is_left_to_it() -> None:
    assert way_to_charger(beside(9.0, CHARGER, FAR))[-1] == Place("1", "1", F0)
    assert way_to_charger(beside(0.2, CHARGER, FAR))[-1] == Place("3", "3", F0)
    with pytest.raises(CommandError, match=f"other robots are at all chargers of {F0}"):
        order_to_charger(beside(0.2, CHARGER))


def with_lifts(*floors: str) -> FleetState:
    """Two floors with a lift each, and a charger on these."""
    graphs = []
    for floor, lift, end in (("floor_0", "9", "91"), ("floor_1", "8", "81")):
        role = Role.DOCKING if floor in floors else Role.PLAIN
        vertices = {lift: Vertex(lift, 5.0, 0.0, Role.ELEVATOR), end: Vertex(end, 15.0, 0.0, role)}
        graphs.append(GraphReceived(R0, floor, RouteGraph(vertices, (Edge("a", lift, end),))))
    return reduced(fleet(1, 2), *graphs, pose(T0, 4.0))


def test_a_charger_on_another_floor_is_reached_by_lift_where_none_is_nearer() -> None:
    assert way_to_charger(with_lifts("floor_1"))[-1] == Place("81", "81", "floor_1")
    assert way_to_charger(with_lifts("floor_0", "floor_1"))[-1] == Place("91", "91", "floor_0")
    robot = with_lifts("floor_1").robots[R0]
    stays = replace(robot, kind=replace(robot.kind, changes_floors=False))
    assert charging.way_to_charger(with_lifts("floor_1"), stays) == ()


def test_a_robot_some_metres_before_its_charger_is_not_at_it() -> None:
    state = at(2.0, graph_of({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)}))
    assert way_to_charger(state) == (Place("2", "2", F0), Place("1", "1", F0))


def test_the_order_leads_from_the_robot_to_the_charger() -> None:
    state = at(4.0, graph_of({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)}))
    request = order_to_charger(state)
    assert request is not None and request.commands == (PlaceOrder(R0, at_vertices("2", "1")),)
    assert request.floors == (("2", F0), ("1", F0))


@pytest.mark.parametrize(
    ("state", "reason"),
    [
        (reduced(fleet(), graph_of({"1": CHARGER})), f"the place of {R0} is not known"),
        (at(4.0, graph_of({})), f"no graph shows a charger on {F0}"),
        (at(0.5, graph_of({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)})), f"{R0} is at a charger"),
        (at(4.0, AWAY), f"no path on the graph leads {R0} to a charger"),
    ],
)
def test_why_there_is_none_is_said(state: FleetState, reason: str) -> None:
    with pytest.raises(CommandError, match=reason):
        order_to_charger(state)


@pytest.mark.parametrize(
    ("features", "doubt"),
    [
        (None, "agv only drives there: without a factsheet nothing starts its charge"),
        (VehicleFeatures(), "agv only drives there: its factsheet has no startCharging"),
        (VehicleFeatures(at_nodes=("startCharging",)), ""),
        (VehicleFeatures(instant=("startCharging",)), ""),
    ],
)
def test_of_a_vehicle_that_is_not_told_to_charge_the_question_says_so(
    features: VehicleFeatures | None, doubt: str
) -> None:
    site = vehicle_at(4.0)
    robot = replace(site.agv, features=features)
    assert charging.order_to_charger(site.state, robot).doubt == doubt
    assert order_to_charger(at(4.0, graph_of({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)}))).doubt == ""


def vehicle_at(x: float, **fields: Any) -> VehicleSite:
    site = VehicleSite()
    site.read("state", state(agvPosition=position(x, 0.0), **fields))
    site.apply(events.FloorGraphLoaded("hall", RouteGraph({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)})))
    return site


def test_a_vehicle_that_charges_by_an_instant_action_alone_gets_that_after_its_order() -> None:
    site, beside = vehicle_at(4.0), VehicleFeatures(instant=("startCharging",))
    order = PlaceOrder("agv", at_vertices("1"))
    request = charging.order_to_charger(site.state, replace(site.agv, features=beside))
    assert request.commands == (order, StartCharging("agv"))
    both = VehicleFeatures(at_nodes=("startCharging",), instant=("startCharging",))
    request = charging.order_to_charger(site.state, replace(site.agv, features=both))
    assert request.commands == (order,), "it is a part of the order"


def test_one_that_stands_at_a_charger_and_does_not_charge_is_only_told_to() -> None:
    beside, power = VehicleFeatures(instant=("startCharging",)), {"batteryCharge": 50.0, "charging": True}
    site = vehicle_at(0.2)
    request = charging.order_to_charger(site.state, replace(site.agv, features=beside))
    assert request.commands == (StartCharging("agv"),)
    site = vehicle_at(0.2, batteryState=power)
    with pytest.raises(CommandError, match="agv is at a charger"):
        charging.order_to_charger(site.state, replace(site.agv, features=beside))
