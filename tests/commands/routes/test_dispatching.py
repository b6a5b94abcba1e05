"""Orders to any robot of a dispatcher."""

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.dispatching import to_any
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.navigation_events import Alive
from fleet_tui.model.order import at_vertices
from tests.support.fleets import F0, T0, fleet, graph, labels, reduced, tick
from tests.support.rmf import rmf_fleet

A, B = Place("1", "A", F0), Place("2", "B", F0)


def known(robot: str) -> tuple[object, ...]:
    return graph(1, 2, robot=robot), labels({"1": "A", "2": "B"}, robot=robot)


def test_the_order_leaves_by_a_robot_that_is_online_and_knows_the_places() -> None:
    state = reduced(rmf_fleet(), *known("robot_0"), *known("robot_1"), Alive("robot_1", T0), tick(T0))  # type: ignore[arg-type]  # events
    found = to_any(state, [A, B])
    assert found is not None
    assert found.commands == (PlaceOrder("robot_1", at_vertices("1", "2"), to_any=True),)
    assert found.floors == (("1", F0), ("2", F0))


def test_without_a_dispatcher_or_a_place_there_is_none() -> None:
    assert to_any(fleet(2), [A]) is None
    assert to_any(rmf_fleet(), [A]) is None
    assert to_any(rmf_fleet(), []) is None
