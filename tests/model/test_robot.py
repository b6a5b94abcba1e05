"""The values of one robot: names of vertices, its queue, its faults."""

from fleet_tui.model.graph import RouteGraph, Vertex
from fleet_tui.model.robot import Robot, RobotMap, with_fault
from fleet_tui.text.language import Message


def robot_map(*ids: str, **labels: str) -> RobotMap:
    vertices = {id_: Vertex(id_, 0.0, 0.0) for id_ in ids}
    return RobotMap(graph=RouteGraph(vertices, ()), labels={id_: text for text, id_ in labels.items()})


def test_a_vertex_is_called_as_the_floor_calls_it_that_the_robot_is_on() -> None:
    maps = {"hall": robot_map("1", Base="1"), "roof": robot_map("1", "2", Attic="1")}
    assert Robot("r", 1, "l", maps, floor="roof").name_of("1") == "Attic"
    assert Robot("r", 1, "l", maps).name_of("1") == "Base"
    assert Robot("r", 1, "l", maps).name_of("2") == "2"
    assert Robot("r", 1, "l", maps).name_of("3") is None


def test_all_graphs_are_known_when_each_floor_has_one() -> None:
    assert not Robot("r", 1, "l", {}).knows_all_graphs()
    assert not Robot("r", 1, "l", {"hall": robot_map("1"), "roof": RobotMap()}).knows_all_graphs()
    assert Robot("r", 1, "l", {"hall": robot_map("1")}).knows_all_graphs()


def test_a_robot_that_never_reported_has_an_empty_queue_and_no_cargo() -> None:
    robot = Robot("r", 1, "l", {})
    assert not robot.orders.orders and not robot.has_cargo


def test_bad_data_is_counted_and_the_newest_is_named_shortly() -> None:
    robot = with_fault(with_fault(Robot("r", 1, "l", {}), Message("one")), Message("x" * 10_000), 3)
    assert robot.faults == 4 and len(robot.last_fault) < 600
