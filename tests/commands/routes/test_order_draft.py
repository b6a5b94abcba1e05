"""The way of an order that is being typed: along the graph, over floors by lift, from the robot if it has no
start."""

from msgspec.structs import replace

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.order_draft import SPEED, Draft, DraftRoute, draft_route, pace_of, stop_at
from fleet_tui.model.events import GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from tests.support.fleets import F0, R0, T0, fleet, graph, pose, queue, reduced

F1 = "floor_1"
ASSUMED = f"an assumed {SPEED} m/s"


def place(vertex: int, floor: str = F0) -> Place:
    return Place(str(vertex), f"place {vertex}", floor)


def with_lift(floor: str, *ids: int) -> GraphReceived:
    """A row whose last vertex is an elevator."""
    row = graph(*ids, floor=floor).graph
    last = str(ids[-1])
    vertices = {**row.vertices, last: replace(row.vertices[last], role=Role.ELEVATOR)}
    return GraphReceived(R0, floor, RouteGraph(vertices, row.edges))


def state() -> FleetState:
    return reduced(fleet(1, 2), pose(T0, 0.4), with_lift(F0, 1, 2, 3, 4), with_lift(F1, 11, 12, 13))


def draft(*places: Place, starts_here: bool = False) -> Draft:
    return Draft(R0, places, starts_here)


def test_the_way_to_a_vertex_ends_at_it() -> None:
    assert stop_at(state().robots[R0], "11") == [(F1, (("11", 0.0),))]


def test_nothing_is_looked_for_before_there_are_two_places() -> None:
    robot = state().robots[R0]
    assert draft_route(robot, draft()) is None
    assert draft_route(robot, draft(place(1))) is None


def test_the_length_is_along_the_graph_and_the_time_is_a_guess_at_a_usual_speed() -> None:
    route = draft_route(state().robots[R0], draft(place(1), place(4), place(2)))
    assert route is not None
    assert (route.metres, route.by_lift) == (5.0, False)
    assert route.text == f"5 m, about 10 s at {ASSUMED}"
    assert len(route.lines[F0]) == 5


def test_the_way_to_its_start_is_told_and_takes_time_too() -> None:
    route = draft_route(state().robots[R0], draft(place(3), place(4)))
    assert route is not None and route.text == f"1 m to the start, then 1 m, about 4 s at {ASSUMED}"
    assert len(route.to_start[F0]) > 0 and route.to_start[F0][-1][2:] == route.lines[F0][0][:2]
    here = draft_route(state().robots[R0], draft(place(3), place(4), starts_here=True))
    assert here is not None and not here.to_start
    by_lift = draft_route(state().robots[R0], draft(place(12, F1), place(13, F1)))
    assert by_lift is not None and by_lift.approach >= 2.0
    unplaced = reduced(fleet(1, 2), with_lift(F0, 1, 2, 3, 4)).robots[R0]
    route = draft_route(unplaced, draft(place(3), place(4)))
    assert route is not None and route.text == f"1 m, about 2 s at {ASSUMED}"


def test_the_way_to_its_start_begins_where_the_last_open_order_ends() -> None:
    ordered = reduced(state(), queue(T0, (7, 1, 2, "W"), (8, 2, 4, "Q"), current=7)).robots[R0]
    route = draft_route(ordered, draft(place(2), place(3)))
    assert route is not None
    assert route.text == f"2 m to the start, then 1 m, about 6 s at {ASSUMED}, plus 2 orders before"


def test_over_floors_it_goes_by_the_lifts() -> None:
    route = draft_route(state().robots[R0], draft(place(2), place(11, F1)))
    assert route is not None
    assert (route.metres, route.by_lift) == (4.0, True)
    assert "by lift" in route.text
    assert {floor: len(lines) for floor, lines in route.lines.items()} == {F0: 2, F1: 2}


def test_without_a_start_it_begins_where_the_robot_is() -> None:
    route = draft_route(state().robots[R0], draft(place(4), starts_here=True))
    assert route is not None
    assert route.metres == 2.0  # from the end of its edge
    unplaced = replace(state().robots[R0], pose=None, floor=None)
    assert draft_route(unplaced, draft(place(4), starts_here=True)) is None


def test_a_place_that_no_way_leads_to_is_said() -> None:
    apart = RouteGraph(
        {"1": Vertex("1", 0, 0), "2": Vertex("2", 1, 0), "9": Vertex("9", 5, 5)}, (Edge("0", "1", "2"),)
    )
    robot = reduced(fleet(), pose(T0), GraphReceived(R0, F0, apart)).robots[R0]
    route = draft_route(robot, draft(place(1), place(9)))
    assert route is not None
    assert route.metres is None
    assert route.text == "no path on the graph"


def test_the_same_place_twice_is_no_way_at_all() -> None:
    route = draft_route(state().robots[R0], draft(place(2), place(2)))
    assert route is not None
    assert route.metres == 0.0


def test_the_time_is_guessed_by_the_speed_at_which_the_robot_or_the_others_drove() -> None:
    poses = [pose(T0 + n / 10, n / 10, robot="robot_1") for n in range(1, 20)]
    drove = reduced(fleet(2), pose(T0, 0.4), *poses)
    assert pace_of(fleet(2), fleet(2).robots[R0]) is None
    pace = pace_of(drove, drove.robots[R0])
    assert pace is not None and abs(pace - 1.0) < 0.01
    route = DraftRoute({}, 55.0, approach=30.0, before=1, pace=pace)
    assert route.text == "30 m to the start, then 55 m, about 85 s at 1.0 m/s, plus 1 order before"
    assert "about 3 min at an assumed" in DraftRoute({}, 55.0, approach=30.0).text
