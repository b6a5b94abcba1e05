"""The orders whose way an edge is on, and their detours."""

import pytest
from msgspec.structs import replace

from fleet_tui.commands.routes.impact import cut_orders
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import EdgeClosed
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import F0, R0, T0, fleet, link_up, pose, queue, reduced
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
    ((name, _, told),) = cut(state, 2, 3)
    assert name == R0 and told.startswith("detour +")
    one_way = fleet_with(pose(T0, 14.0, 0.0), queue(T0, (1, 3, 5, "W"), current=1), robots=1, directed=True)
    assert [text for *_, text in cut(one_way, 2, 3)] == ["no way"]


def test_the_way_to_the_graph_is_a_part_of_the_way_and_of_the_detour() -> None:
    state = fleet_with(pose(T0, 4.0, 0.0), queue(T0, (1, 2, 3, "W"), current=1))
    (found,) = cut_orders(state, ends_of(F0, "2", "3"))
    assert (found.metres, found.around) == pytest.approx((16.0, 6.0 + AROUND))


def test_without_a_graph_or_a_pose_nothing_is_told() -> None:
    state = reduced(fleet(), link_up(T0), pose(T0), queue(T0, (1, 1, 5, "W"), current=1))
    assert cut(state, 2, 3) == []
    assert cut(fleet_with(queue(T0, (1, 1, 5, "W"), current=1)), 2, 3) == []


def test_another_way_that_is_no_longer_is_no_detour() -> None:
    state = fleet_with(pose(T0, 0.0, 0.0), queue(T0, (1, 1, 5, "W"), current=1))
    (found,) = cut_orders(state, ends_of(F0, "2", "3"))
    same = replace(found, around=found.metres)
    assert (found.text[:8], same.text) == ("detour +", "another route, as long")
