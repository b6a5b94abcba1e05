"""The metres that are left of an order: from the robot over the stops to come, on the graph."""

from fleet_tui.commands.routes.remaining import metres_left
from fleet_tui.model.events import CargoReported, Event
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import R0, T0, fleet, graph, pose, queue, reduced


def driving(*facts: Event) -> FleetState:
    """At 1 m of a row of vertices 1 m apart, with an order from vertex 3 to 4."""
    order = queue(T0, (7, 3, 4, "W"), current=7)
    return reduced(fleet(), graph(1, 2, 3, 4), pose(T0, 1.0), order, *facts)


def left(state: FleetState) -> float | None:
    robot = state.robots[R0]
    assert robot.orders.current is not None
    return metres_left(robot, robot.orders.current)


def test_the_way_goes_over_the_stops_that_are_left() -> None:
    assert left(driving()) == 2.0
    assert left(driving(pose(T0 + 1, 0.0))) == 3.0
    assert left(driving(CargoReported(R0, T0, True), pose(T0 + 1, 2.0))) == 1.0


def test_nothing_is_said_of_an_unknown_way() -> None:
    off_the_graph = reduced(driving(), queue(T0 + 1, (7, 3, 9, "W"), current=7))
    assert left(off_the_graph) is None
    nowhere = reduced(fleet(), graph(1, 2, 3, 4), queue(T0, (7, 3, 4, "W"), current=7))
    assert left(nowhere) is None
