"""Orders by the labels of their stops."""

from fleet_tui.view.tables.missions import destinations, mission
from tests.support.fleets import R0, T0, fleet, graph, labels, queue, reduced


def test_a_mission_marks_a_vertex_that_no_graph_has() -> None:
    state = reduced(fleet(), graph(1, 2), labels({1: "Base"}), queue(T0, (4, 1, 77, "W")))
    robot = state.robots[R0]
    assert mission(robot, robot.orders.orders[0]) == "Base -> 77?"
    assert destinations(robot, robot.orders.orders[0]) == "-> 77?"
