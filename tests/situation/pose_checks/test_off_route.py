"""How far a robot is from its edges."""

import pytest

from fleet_tui.situation.pose_checks.off_route import OFF_GRAPH, is_off_route, metres_off
from tests.support.fleets import R0, T0, fleet, graph, link_up, pose, queue, reduced, tick


@pytest.mark.parametrize(("y", "has_order"), [(2.6, True), (2.6, False), (OFF_GRAPH - 0.1, True)])
def test_a_robot_with_an_order_is_off_its_route_two_metres_from_all_edges(y: float, has_order: bool) -> None:
    orders = queue(T0, (1, 3, 1, "W"), current=1) if has_order else queue(T0)
    robot = reduced(fleet(), link_up(T0 - 9), graph(1, 2, 3), pose(T0, 1.4, y), orders, tick(T0)).robots[R0]
    assert metres_off(robot) == pytest.approx(y)
    assert is_off_route(robot) == (has_order and y > OFF_GRAPH)


def test_without_a_graph_or_a_pose_nothing_is_known_of_it() -> None:
    lost = reduced(
        fleet(), link_up(T0 - 9), pose(T0, 1.4, 9.0), queue(T0, (1, 3, 1, "W"), current=1), tick(T0)
    )
    assert not is_off_route(lost.robots[R0])
    assert metres_off(reduced(fleet(), link_up(T0 - 9), graph(1, 2, 3), tick(T0)).robots[R0]) == 0.0
