"""Checks of an order against graphs and floors: ways, elevators, ids that mean two places."""

from fleet_tui.commands.checks import problems
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.events import GraphReceived
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.kind import ORDER as PLACES
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Stop
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from tests.support.checked_orders import F1, floor, found, ready
from tests.support.fleets import F0, R0, graph, labels, of_kinds, place_order


def test_floors_are_joined_by_elevators_that_the_graphs_name() -> None:
    up = place_order(R0, 1, 10)
    with_lifts = ready(floor(1, 2, 3, lift=3), floor(9, 10, lift=9), floors=2)
    assert found(with_lifts, up) == []
    cut_off = ready(floor(1, 2, 3, lift=3), floor(9, 10, lift=9, joined=False), floors=2)
    assert found(cut_off, up) == [("no path", True)]
    none_named = ready(floor(9, 10), floors=2)
    assert found(none_named, up) == [("floor mismatch", False)]
    (problem,) = problems(
        of_kinds(none_named, Kind(changes_floors=False, accepts=(PLACES,))), Request((up,)), Permissions()
    )
    assert problem.blocks
    assert problem.text == f"Base is on {F0}, 10 on {F1}: an order can't change floors"
    not_yet = ready(floors=2)
    assert found(not_yet, up) == [("unknown vertex", False)]


def test_a_pose_between_two_vertices_is_a_way_of_its_own() -> None:
    there = Stop(pose=Pose(1.0, 2.0))
    apart = ready(floor(1, 2, 3, joined=False))
    for stops in ((Stop("1"), there, Stop("1")), (Stop("1"), there, Stop("3")), (there,), (Stop("1"), there)):
        named = {problem for problem, blocks in found(apart, PlaceOrder(R0, stops)) if blocks}
        assert not named & {"same place", "no path", "unknown vertex"}
    assert ("no path", True) in found(apart, place_order(R0, 1, 2, 3))


def test_a_start_that_is_not_reached_from_where_the_robot_is_is_warned_of() -> None:
    apart = RouteGraph({str(n): Vertex(str(n), n * 5.0, 0.0) for n in (1, 2, 3)}, (Edge("0", "2", "3"),))
    state = ready(GraphReceived(R0, F0, apart))
    assert found(state, place_order(R0, 2, 3)) == [("no path", False)]


def test_a_place_chosen_on_another_floor_whose_id_is_another_place_here() -> None:
    """Ids of floors may be the same; the wire knows only ids."""
    state = ready(graph(1, 2, 10, floor=F1), labels({1: "Attic", 2: "Roof"}, F1), floors=2)
    assert found(state, place_order(R0, 1, 2), v1=F0, v2=F0) == []
    assert found(state, place_order(R0, 1, 2), v1=F1, v2=F1) == [("floor mismatch", True)] * 2


def test_a_place_of_another_floor_with_the_label_and_the_id_of_one_here() -> None:
    state = ready(graph(1, 2, 10, floor=F1), labels({1: "Base", 2: "Store"}, F1), floors=2)
    assert ("floor mismatch", True) in found(state, place_order(R0, 1, 2), v1=F0, v2=F1)


def test_an_order_that_names_one_id_on_two_floors() -> None:
    state = ready(graph(1, 2, 10, floor=F1), labels({1: "Attic", 2: "Roof"}, F1), floors=2)
    orders = place_order(R0, 1, 2), place_order(R0, 2, 1)
    request = Request(orders, (("1", F1), ("2", F0), ("1", F0)))
    assert ("floor mismatch", True) in [
        (one.check, one.blocks) for one in problems(state, request, Permissions())
    ]
