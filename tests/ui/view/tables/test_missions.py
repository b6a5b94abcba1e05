"""Orders by the labels of their stops."""

from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.ui.view.tables.missions import destinations, mission, whose_mission
from tests.support.fleets import R0, T0, fleet, graph, labels, queue, reduced
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import node, state


def test_a_mission_marks_a_vertex_that_no_graph_has() -> None:
    state = reduced(fleet(), graph(1, 2), labels({1: "Base"}), queue(T0, (4, 1, 77, "W")))
    robot = state.robots[R0]
    assert mission(robot, robot.orders.orders[0]) == "Base -> 77?"
    assert destinations(robot, robot.orders.orders[0]) == "-> 77?"


def test_an_order_of_the_same_operators_shell_is_his_own_and_another_ones_is_marked() -> None:
    site = VehicleSite()
    site.read("state", state())
    (sent,) = site.adapter.outgoing(PlaceOrder("agv", (Stop(pose=Pose(9.0, 2.0)),)), 1, site.agv, "0" * 32)
    for id_, mark in ((sent.name, ""), ("theirs", " (elsewhere)")):  # type: ignore[union-attr]  # a message, which has a name
        site.read("state", state(orderId=id_, nodeStates=[node("a", 2)]))
        (order,) = site.agv.orders.open
        assert whose_mission(site.state, site.agv, order) == f"-> a?{mark}"
