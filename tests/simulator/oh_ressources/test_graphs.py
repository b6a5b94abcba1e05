"""Graphs sent to the source's robots: driven on, published again, and survived whatever they lack."""

import math
from itertools import pairwise
from typing import Any

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1

GRAPH, LABELS = "graph", "labeled_vertices"


def drawn(*spots: tuple[int, float, float], types: dict[int, str] | None = None) -> dict[str, Any]:
    """Vertices in a row, each joined to the next."""
    vertices = [{"id": id_, "x": x, "y": y, "type": (types or {}).get(id_, "way")} for id_, x, y in spots]
    ids = [id_ for id_, _, _ in spots]
    pairs = pairwise(ids)
    return {
        "vertices": vertices,
        "edges": [{"id": n, "start": a, "end": b} for n, (a, b) in enumerate(pairs)],
    }


ROW = drawn((50, 0.0, 0.0), (51, 4.0, 0.0), (52, 8.0, 0.0))


def named(**labels: str) -> dict[str, Any]:
    return {"vertices": [{"vertex_id": int(id_[1:]), "label": label} for id_, label in labels.items()]}


def take(fleet: OhFleet, topic: str, message: dict[str, Any], floor: str = "floor_0") -> None:
    fleet.subscriptions()[f"/robot_0/{floor}/{topic}"][1](message)


def latched(fleet: OhFleet, name: str, robot: str = "robot_0", floor: str = "floor_0") -> dict[str, Any]:
    topics = {topic.name: topic for topic in fleet.topics(0.0, ROS1)}
    msg: dict[str, Any] = topics[f"/{robot}/{floor}/{name}"].payload(0.0).msg
    return msg


def quiet(floors: int = 1, robots: int = 2) -> OhFleet:
    return OhFleet(robots, floors, seed=1, quiet=True)


def test_all_robots_of_the_world_get_it_and_publish_it() -> None:
    fleet = quiet()
    topics = {topic.name: topic for topic in fleet.topics(0.0, ROS1)}
    take(fleet, "graph_save", ROW)
    take(fleet, "labels_save", named(v51="Middle"))
    take(fleet, "labels_save", named(v52="End", v99="Nowhere"))
    news = {name: payload.msg for name, payload in fleet.news(ROS1)}
    labels = {"vertices": [{"label": "Middle", "vertex_id": 51}]}
    assert news == {
        f"/robot_{n}/floor_0/{name}": msg for n in (0, 1) for name, msg in ((GRAPH, ROW), (LABELS, labels))
    }
    assert [topics[f"/robot_1/floor_0/{name}"].payload(1.0).msg for name in (GRAPH, LABELS)] == [ROW, labels]
    assert list(fleet.news(ROS1)) == []
    assert latched(quiet(), GRAPH) != ROW  # another world has its own floors


def test_labels_never_outlive_their_vertices() -> None:
    fleet = quiet()
    first = latched(fleet, LABELS)["vertices"][0]
    take(fleet, "graph_save", drawn((first["vertex_id"], 0.0, 0.0), (60, 1.0, 0.0)))
    assert latched(fleet, LABELS) == {"vertices": [first]}


def test_a_robot_whose_vertex_is_gone_drives_on_from_the_nearest() -> None:
    fleet = quiet()
    robot = fleet.robots["robot_0"]
    robot.take(0, 1, 1)
    fleet.step(4.0)
    take(fleet, "graph_save", ROW)
    assert robot.vertex in (50, 51, 52)
    robot.drop({1})
    robot.take(52, 50, 2)
    fleet.step(120.0)
    assert (robot.vertex, robot.orders) == (50, [])
    assert math.dist((robot.pose.x, robot.pose.y), (0.0, 0.0)) < 1e-6


def test_an_order_to_a_vertex_that_is_gone_waits_for_its_end() -> None:
    fleet = quiet()
    robot = fleet.robots["robot_0"]
    robot.take(0, 1, 1)
    take(fleet, "graph_save", ROW)
    fleet.step(60.0)
    assert robot.current_order_id == 1 and robot.bound is None
    robot.drop({1})
    refused = fleet.answer(
        "/robot_0/Application_layout/Execute_order", {"request_id": 1, "initial_point": 0, "end_point": 51}
    )
    assert refused["status"] == "REJECTED: no vertex 0" and not robot.orders


def test_cargo_of_an_order_in_process_stays_on_board() -> None:
    fleet = quiet()
    robot = fleet.robots["robot_0"]
    other = next(id_ for id_ in fleet.building.graph.vertices if id_ != robot.vertex)
    robot.take(robot.vertex, other, 1)
    fleet.step(4.0)
    assert robot.cargo
    graph = latched(fleet, GRAPH)
    take(fleet, "graph_save", graph)
    fleet.step(120.0)
    assert not robot.orders and robot.vertex == other


@pytest.mark.parametrize(
    "message",
    [
        {"vertices": [], "edges": []},
        drawn((50, math.nan, 0.0)),
        drawn((100, 0.0, 0.0)),  # of floor_1
    ],
)
def test_a_graph_that_cannot_be_driven_on_is_dropped(message: dict[str, Any]) -> None:
    fleet = quiet(floors=2)
    take(fleet, "graph_save", message)
    assert list(fleet.news(ROS1)) == []


def test_edges_to_unknown_vertices_are_dropped() -> None:
    fleet = quiet()
    take(fleet, "graph_save", ROW | {"edges": [*ROW["edges"], {"id": 9, "start": 50, "end": 77}]})
    assert latched(fleet, GRAPH) == ROW


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(
    ("labels", "types"), [({}, {}), ({"v50": "A", "v52": "B"}, {}), ({"v50": "A"}, {51: "elevator"})]
)
def test_a_busy_world_lives_on_without_labels_lifts_and_chargers(
    seed: int, labels: dict[str, str], types: dict[int, str]
) -> None:
    fleet = OhFleet(4, 2, seed=seed)
    fleet.step(20.0 + seed * 7.3)
    row = drawn((50, 0.0, 0.0), (51, 4.0, 0.0), (52, 8.0, 0.0), types=types)
    take(fleet, "graph_save", row)
    take(fleet, "labels_save", named(**labels))
    fleet.step(200.0)
    take(fleet, "graph_save", drawn((7, 3.0, 3.0)), floor="floor_1")
    for robot in fleet.robots.values():
        robot.battery = 20.0
    fleet.step(200.0)
    known = fleet.building.graph.vertices
    assert all(robot.vertex in known for robot in fleet.robots.values())
