"""Requests: what an operator wants, as commands of what robots of each kind take."""

from fleet_tui.model.commands import PauseRobot, PlaceOrder
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import chain, given_now
from tests.support.fleets import R0, place_order


def test_a_b_c_is_two_orders_and_cargo_goes_to_the_first_place() -> None:
    assert chain(R0, ["1", "2", "3"]) == (place_order(R0, 1, 2), place_order(R0, 2, 3))
    assert chain(R0, ["1", "2"], with_cargo=True) == (place_order(R0, 1), place_order(R0, 1, 2))
    assert chain(R0, ["1"], with_cargo=True) == (place_order(R0, 1),)


def test_a_robot_that_drives_goals_takes_a_chain_as_one_order() -> None:
    assert chain(R0, ["1", "2", "3"], in_one=True) == (PlaceOrder(R0, at_vertices("1", "2", "3")),)
    assert chain(R0, ["3"], with_cargo=True, in_one=True) == (PlaceOrder(R0, at_vertices("3")),)


def test_a_robot_that_takes_one_stop_is_given_one_after_the_other() -> None:
    order, by_stops = place_order(R0, 1, 2), Kind(gives_stops=True)
    assert [given_now(order, by_stops, leg) for leg in (0, 1)] == [place_order(R0, 1), place_order(R0, 2)]
    assert given_now(order, Kind(), 1) is order
    assert given_now(PauseRobot(R0), by_stops) == PauseRobot(R0)
