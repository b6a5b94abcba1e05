"""The orders whose way an edge is on, and their detours."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import EdgeClosed
from fleet_tui.model.events import ObstacleReported, PoseReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.rules.routes.impact import cut_orders, edge_under, is_in_the_way
from tests.support.fleets import F0, R0, T0, fleet, link_up, pose, queue, reduced, tick
from tests.support.street import AROUND, fleet_with


def cut(state: FleetState, one: int, other: int) -> list[tuple[str, str, str]]:
    """Return robot, order and detour of each order that an edge is on."""
    found = cut_orders(state, ends_of(F0, str(one), str(other)))
    return [(each.robot, each.order.id, each.text) for each in found]


def test_an_order_over_the_edge_has_its_detour_and_others_are_not_told() -> None:
    state = fleet_with(
        pose(T0, 0.0, 0.0),
        queue(T0, (1, 1, 5, "W"), current=1),
        pose(T0, 30.0, 0.0, robot="robot_1"),
        queue(T0, (2, 5, 3, "W"), current=2, robot="robot_1"),
    )
    assert cut(state, 2, 3) == [(R0, "1", f"detour +{AROUND - 10:.0f} m ({20 + AROUND:.0f} m)")]
    assert cut(state, 3, 5) == [(R0, "1", "no way"), ("robot_1", "2", "no way")]
    assert cut(state, 2, 4) == []


def test_orders_that_wait_begin_where_the_one_before_them_ends() -> None:
    state = fleet_with(pose(T0, 0.0, 0.0), queue(T0, (1, 1, 2, "W"), (2, 2, 3, "W"), current=1))
    assert [(robot, order) for robot, order, _ in cut(state, 2, 3)] == [(R0, "2")]


def test_ways_avoid_the_edges_that_are_closed_already() -> None:
    closed = EdgeClosed(ends_of(F0, "4", "3"), 0.0)
    state = fleet_with(pose(T0, 0.0, 0.0), queue(T0, (1, 1, 3, "W"), current=1), closed)
    assert cut(state, 2, 3) == [(R0, "1", "no way")]
    state = reduced(state, EdgeClosed(ends_of(F0, "2", "3"), 0.0))
    assert cut(state, 4, 3) == [(R0, "1", "no way")]  # opened again, the other would be on it


def test_a_robot_between_the_ends_has_to_turn_back() -> None:
    state = fleet_with(pose(T0, 14.0, 0.0), queue(T0, (1, 3, 5, "W"), current=1), robots=1)
    robot = state.robots[R0]
    assert edge_under(robot) == ends_of(F0, "2", "3")
    ((name, _, told),) = cut(state, 2, 3)
    assert name == R0 and told.startswith("detour +")
    one_way = fleet_with(pose(T0, 14.0, 0.0), queue(T0, (1, 3, 5, "W"), current=1), robots=1, directed=True)
    assert [text for *_, text in cut(one_way, 2, 3)] == ["no way"]


def test_without_a_graph_or_a_pose_nothing_is_told() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0), queue(T0, (1, 1, 5, "W"), current=1))
    assert cut(state, 2, 3) == [] and edge_under(state.robots[R0]) is None
    assert cut(fleet_with(queue(T0, (1, 1, 5, "W"), current=1)), 2, 3) == []


@pytest.mark.parametrize(("seconds", "blocks"), [(0.0, False), (5.0, False), (40.0, True)])
def test_a_robot_in_contact_is_in_the_way(seconds: float, blocks: bool) -> None:
    state = fleet_with(pose(T0, 14.0, 0.0), ObstacleReported(R0, T0, seconds))
    assert is_in_the_way(state, state.robots[R0], ()) is blocks


def test_another_way_that_is_no_longer_is_no_detour() -> None:
    state = fleet_with(pose(T0, 0.0, 0.0), queue(T0, (1, 1, 5, "W"), current=1))
    (found,) = cut_orders(state, ends_of(F0, "2", "3"))
    same = replace(found, around=found.metres)
    assert (found.text[:8], same.text) == ("detour +", "another way, as long")


@pytest.mark.parametrize(
    ("yaw", "ahead"), [(0.1, ("2", "3")), (3.1, ("1", "2")), (1.5, ("2", "4")), (-1.5, None)]
)
def test_at_a_vertex_it_is_the_edge_that_the_robot_faces(yaw: float, ahead: tuple[str, str] | None) -> None:
    robot = fleet_with(PoseReported(R0, T0, Pose(10.2, 0.0, yaw), F0, None), robots=1).robots[R0]
    assert edge_under(robot) == (ends_of(F0, *ahead) if ahead else None)


def test_a_robot_whose_pose_has_just_jumped_blocks_no_edge() -> None:
    contact = ObstacleReported(R0, T0, 40.0)
    state = fleet_with(pose(T0 - 0.1, 0.0, 0.0), pose(T0, 14.0, 0.0), contact)
    assert not is_in_the_way(state, state.robots[R0], (R0,))
    later = reduced(state, pose(T0 + 31, 14.0, 0.0), ObstacleReported(R0, T0 + 31, 71.0), tick(T0 + 31))
    assert is_in_the_way(later, later.robots[R0], ())
