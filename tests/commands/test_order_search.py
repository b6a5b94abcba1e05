"""The order that a command placed, found in the queue of its robot."""

from fleet_tui.commands.order_search import could_be, find_order
from fleet_tui.model.order import Order, at_vertices
from tests.support.fleets import R0, T0, commanded, place_order, queue, reduced
from tests.support.one_command import ORDER, SENT, only, up


def test_a_new_order_with_the_same_stops_is_the_one() -> None:
    state = reduced(up(), *commanded(1, ORDER, SENT), queue(T0 + 1, (5, 1, 2, "Q")))
    found = find_order(state, state.robots[R0], only(state))
    assert found is not None and found.id == "5"


def test_an_older_or_another_one_is_not() -> None:
    for listed in ((4, 1, 2, "Q"), (5, 1, 3, "Q")):
        state = reduced(up(), *commanded(1, ORDER, SENT), queue(T0 + 1, listed))
        assert find_order(state, state.robots[R0], only(state)) is None


def test_cargo_begins_anywhere() -> None:
    order = Order("5", at_vertices("9", "2"), None, "Q", 5)
    assert could_be(place_order(R0, 2), order) and not could_be(place_order(R0, 1, 2), order)
