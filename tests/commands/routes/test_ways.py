"""Shortest ways along a graph, and the edge that a robot is on."""

import math

from fleet_tui.commands.routes.ways import Routes, routes_of
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.robot import RobotMap

ONE_WAY = RouteGraph(
    {"a": Vertex("a", 0.0, 0.0), "b": Vertex("b", 4.0, 0.0), "c": Vertex("c", 4.0, 3.0)},
    (Edge("0", "a", "b"), Edge("1", "b", "c")),
    directed=True,
)


def test_of_several_starts_and_goals_the_nearest_pair_counts() -> None:
    routes = Routes(ONE_WAY)
    way = routes.shortest((("a", 0.0), ("b", 1.0)), (("c", 0.0),))
    assert (way.start, way.length) == ("b", 3.0)
    assert routes.shortest((("c", 0.0),), (("a", 0.0),)).length == math.inf


def test_a_robot_on_a_one_way_edge_can_only_go_on() -> None:
    (ahead, behind) = Routes(ONE_WAY).near(Pose(1.5, 0.2))
    assert ahead[0] == "b" and math.isclose(ahead[1], math.dist((1.5, 0.2), (4.0, 0.0)))
    assert behind == ("a", math.inf)
    assert Routes(ONE_WAY).near(Pose(math.nan, 0.0)) == ()


def test_an_elevator_is_where_its_vertex_is() -> None:
    graph = RouteGraph({"a": Vertex("a", 0.0, 0.0), "e": Vertex("e", 4.0, 0.0, Role.ELEVATOR)}, ())
    assert Routes(graph).elevators == (("e", 0.0),)


def test_a_map_without_a_graph_has_no_routes() -> None:
    assert routes_of(RobotMap()) is None


def test_robots_with_the_same_graph_have_the_same_routes() -> None:
    first, second = RobotMap(graph=ONE_WAY), RobotMap(graph=ONE_WAY, labels={"a": "Base"})
    assert routes_of(first) is routes_of(second)
