"""The way that is still to be driven: which edges, from where, and on which floor."""

from itertools import pairwise

import pytest
from msgspec import structs

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.order_draft import Draft, draft_route
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.order import Order, OrderQueue, OrderState, Stop
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.scene import Mission, Scene
from fleet_tui.ui.view.selection import Selection
from tests.support.fleets import F0, R0, T0, fleet, graph, pose, queue, reduced, tick

F1 = "floor_1"
Metres = tuple[float, float]


def scene(state: FleetState, floor: str = F0) -> Scene:
    return floor_scene(state, Selection(R0, floor))


def mission(state: FleetState, floor: str = F0) -> Mission:
    found = scene(state, floor).mission
    assert found is not None
    return found


def places(lines: tuple[tuple[float, float, float, float], ...]) -> list[Metres]:
    """The places that lines lead through, which must hang together."""
    assert all(one[2:] == other[:2] for one, other in pairwise(lines))
    return [line[:2] for line in lines] + [line[2:] for line in lines[-1:]]


def ahead(found: Mission) -> Metres:
    """The vertex that the robot drives to now."""
    assert found.edge is not None
    return found.edge[2:]


def row(*xs: float) -> list[Metres]:
    return [(x, 0.0) for x in xs]


def carrying(loaded: bool) -> events.CargoReported:
    return events.CargoReported(R0, T0, loaded)


# Vertices 1 to 5 lie at x = 0 to 4.
ROW = graph(1, 2, 3, 4, 5)
DRIVING = (ROW, pose(T0, 0.4, 0.1), queue(T0, (1, 3, 5, "W"), (2, 4, 2, "Q"), current=1))


def test_the_current_order_leads_from_the_robot_over_its_start_to_its_end() -> None:
    found = mission(reduced(fleet(), *DRIVING))
    assert ahead(found) == (1.0, 0.0)
    assert places(found.current) == row(1, 2, 3, 4)


def test_with_the_cargo_on_board_it_leads_straight_to_its_end() -> None:
    state = reduced(fleet(), ROW, pose(T0, 3.4), carrying(True), queue(T0, (1, 1, 5, "W"), current=1))
    assert (ahead(mission(state)), mission(state).current) == ((4.0, 0.0), ())
    empty = reduced(state, carrying(False))
    assert places(mission(empty).current) == row(3, 2, 1, 0, 1, 2, 3, 4)
    assert mission(empty).edge == (4.0, 0.0, 3.0, 0.0)


def test_the_next_orders_lead_on_from_the_end_of_the_one_before() -> None:
    found = mission(reduced(fleet(), *DRIVING))
    assert places(found.following) == row(4, 3, 2, 1)


def test_without_a_current_order_the_first_is_the_way_all_the_same() -> None:
    found = mission(reduced(fleet(), ROW, pose(T0, 0.0), queue(T0, (2, 2, 3, "Q"), (3, 3, 4, "Q"))))
    assert places(found.following) == row(2, 3)
    assert found.edge is not None and places(found.current) == row(1, 2)


def test_what_has_ended_is_driven_no_more_and_no_orders_are_no_mission() -> None:
    ended = reduced(fleet(), ROW, pose(T0), queue(T0, (1, 1, 3, "D"), (2, 2, 3, "C")))
    assert scene(ended).mission is None
    assert scene(reduced(fleet(), ROW, pose(T0))).mission is None


def test_the_backdrop_does_not_move_with_the_robot_on_its_edge() -> None:
    state = reduced(fleet(), *DRIVING)
    before = mission(state)
    after = mission(reduced(state, pose(T0 + 1, 0.6), tick(T0 + 1)))
    assert after == before
    assert all(one is other for one, other in zip(before.current, after.current, strict=True))
    assert mission(reduced(state, pose(T0 + 2, 1.4))).edge == (1.0, 0.0, 2.0, 0.0)


def square(directed: bool) -> events.GraphReceived:
    """1 (0,0) -> 2 (9,0) -> 3 (9,9) -> 4 (0,9) -> 1, ten metres of hall between the sides."""
    corners = {1: (0.0, 0.0), 2: (9.0, 0.0), 3: (9.0, 9.0), 4: (0.0, 9.0)}
    edges = tuple(Edge(str(n), str(n), str(n % 4 + 1)) for n in corners)
    vertices = {str(n): Vertex(str(n), *place) for n, place in corners.items()}
    return events.GraphReceived(R0, F0, RouteGraph(vertices, edges, directed))


def test_a_one_way_edge_is_not_driven_backwards() -> None:
    to_start = queue(T0, (1, 1, 3, "W"), current=1)
    both_ways = mission(reduced(fleet(), square(False), pose(T0, 3.0, 0.0), to_start))
    assert ahead(both_ways) == (0.0, 0.0)
    one_way = mission(reduced(fleet(), square(True), pose(T0, 3.0, 0.0), to_start))
    assert ahead(one_way) == (9.0, 0.0)
    assert places(one_way.current)[:4] == [(9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)]
    at_start = mission(reduced(fleet(), square(True), pose(T0, 0.2, 0.0), to_start))
    assert ahead(at_start) == (0.0, 0.0)


def two_floors(lifts: tuple[int, ...] = (2,)) -> list[events.Event]:
    """Vertices 1, 2, 3 below and 11, 12, 13 above; the second of each row is an elevator."""
    facts: list[events.Event] = []
    for floor, ids in ((F0, (1, 2, 3)), (F1, (11, 12, 13))):
        plain = graph(*ids, floor=floor).graph
        vertices = {
            n: structs.replace(vertex, role=Role.ELEVATOR if int(n) % 10 in lifts else Role.PLAIN)
            for n, vertex in plain.vertices.items()
        }
        facts.append(events.GraphReceived(R0, floor, RouteGraph(vertices, plain.edges)))
    return facts


def test_a_leg_to_another_floor_ends_at_the_elevator_and_goes_on_there() -> None:
    state = reduced(fleet(1, 2), *two_floors(), pose(T0, 0.0), queue(T0, (1, 1, 13, "W"), current=1))
    assert places(mission(state).current) == row(0, 1)
    assert places(mission(state, F1).current) == row(1, 2)
    assert mission(state, F1).edge is None
    assert scene(state).target_vertices == ("1",)
    assert scene(state, F1).target_vertices == ("13",)


def test_without_an_elevator_the_other_floor_is_out_of_reach() -> None:
    state = reduced(fleet(1, 2), *two_floors(()), pose(T0, 0.0), queue(T0, (1, 1, 13, "W"), current=1))
    assert mission(state).current == ()
    assert mission(state, F1).current == ()


def test_ids_that_repeat_belong_to_the_floor_the_robot_is_on() -> None:
    same = [graph(1, 2, 3, floor=floor) for floor in (F0, F1)]
    state = reduced(fleet(1, 2), *same, pose(T0, 0.0, frame=F1), queue(T0, (1, 1, 3, "W"), current=1))
    assert places(mission(state, F1).current) == row(0, 1, 2)
    assert mission(state).current == ()
    assert scene(state).target_vertices == ()


@pytest.mark.parametrize(
    "facts",
    [
        (pose(T0, 0.0), queue(T0, (1, 77, 3, "W"), current=1)),  # a vertex that is nowhere
        (pose(T0, 1e4, -1e4), queue(T0, (1, 1, 3, "W"), current=1)),
        (queue(T0, (1, 3, 1, "W"), current=1),),  # no pose yet
        (pose(T0, frame="attic"), queue(T0, (1, 3, 1, "W"), current=1)),
    ],
)
def test_whatever_comes_makes_a_scene(facts: tuple[events.Event, ...]) -> None:
    assert scene(reduced(fleet(), ROW, *facts)).mission is not None
    assert scene(reduced(fleet(), *facts)).mission is None
    lonely = events.GraphReceived(
        R0, F0, RouteGraph({"1": Vertex("1", 0.0, 0.0), "3": Vertex("3", 1.0, 0.0)})
    )
    assert mission(reduced(fleet(), lonely, *facts)).current == ()


def test_an_order_to_a_pose_or_to_nowhere_known_has_no_way_along_the_graph() -> None:
    for stops in ((), (Stop(pose=Pose(3.0, 0.0)),)):
        orders = (Order("a", stops, OrderState.IN_PROCESS, "", 1),)
        reported = events.QueueReported(R0, T0, OrderQueue(1, "a", orders))
        found = scene(reduced(fleet(), ROW, pose(T0), reported))
        assert found.mission == Mission((), ()) and found.target_vertices == ()


def test_one_way_edges_are_those_without_a_way_back() -> None:
    vertices = {str(n): Vertex(str(n), float(n), 0.0) for n in (1, 2, 3)}
    edges = (Edge("1", "1", "2"), Edge("2", "2", "1"), Edge("3", "2", "3"))
    for directed, found in ((True, ((2.0, 0.0, 3.0, 0.0),)), (False, ())):
        received = events.GraphReceived(R0, F0, RouteGraph(vertices, edges, directed))
        assert scene(reduced(fleet(), received)).one_way == found


def test_the_edge_on_which_a_robot_with_an_alarm_stands_is_marked_while_it_lasts() -> None:
    contact = events.ObstacleReported(R0, T0, 40.0)
    found = reduced(fleet(), *DRIVING, contact)
    assert scene(found).blocked == (), "no alarm yet: contact ends by itself on most drives"
    found = reduced(found, tick(T0 + 0.1))
    assert [set(places((line,))) for line in scene(found).blocked] == [{(0.0, 0.0), (1.0, 0.0)}]
    gone = reduced(found, events.ObstacleReported(R0, T0 + 1, 0.0), pose(T0 + 1, 0.4), tick(T0 + 9))
    assert scene(gone).blocked == ()


def test_of_an_order_being_typed_the_way_to_its_start_is_as_one_that_follows() -> None:
    state = reduced(fleet(1), pose(T0, 0.0), graph(1, 2, 3, 4))
    draft = Draft(R0, (Place("3", "C", F0), Place("4", "D", F0)))
    found = floor_scene(state, Selection(R0, F0), (draft, draft_route(state.robots[R0], draft))).mission
    assert found is not None
    assert found.current[0][:2] == found.following[-1][2:] != found.following[0][:2]
