"""Requests: what an operator wants of robots at once."""

from fleet_tui.model.commands import (
    PlaceOrder,
)
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import chain
from tests.support.fleets import (
    R0,
)


def test_a_robot_that_drives_goals_takes_a_chain_as_one_order() -> None:
    assert chain(R0, ["1", "2", "3"], in_one=True) == (PlaceOrder(R0, at_vertices("1", "2", "3")),)
    assert chain(R0, ["3"], with_cargo=True, in_one=True) == (PlaceOrder(R0, at_vertices("3")),)
