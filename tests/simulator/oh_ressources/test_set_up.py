"""Set-up of the source's robots: a pose from outside, a goal beside the orders."""

import math
from typing import Any

from fleet_tui.simulator.oh_ressources.fleet import SUBSCRIPTIONS, OhFleet


def placed(x: float, y: float, frame: str = "floor_0", w: float = 1.0) -> dict[str, Any]:
    turn = {"x": 0.0, "y": 0.0, "z": 0.0, "w": w}
    return {
        "header": {"frame_id": frame},
        "pose": {"position": {"x": x, "y": y, "z": 0.0}, "orientation": turn},
    }


def world() -> OhFleet:
    return OhFleet(1, 1, seed=1, quiet=True)


def test_a_pose_is_believed() -> None:
    robot = world().robots["robot_0"]
    _, take = SUBSCRIPTIONS["initialpose"]
    take(robot, {**placed(0.0, 0.0), "pose": placed(9.0, 9.0, w=0.0)})
    assert robot.belief.of(robot.pose).x == 9.0
    take(robot, {**placed(0.0, 0.0, "attic"), "pose": placed(1.0, 1.0)})
    assert robot.belief.of(robot.pose).x == 9.0


def test_a_goal_is_driven_to_and_an_order_afterwards() -> None:
    it = world()
    robot = it.robots["robot_0"]
    SUBSCRIPTIONS["goal"][1](robot, placed(robot.pose.x + 0.5, robot.pose.y + 0.3))
    x, y = robot.pose.x + 0.5, robot.pose.y + 0.3
    it.step(10.0)
    assert math.dist((robot.pose.x, robot.pose.y), (x, y)) < 1e-6 and robot.pose.yaw == 0.0
    ids = list(it.building.graph.vertices)
    robot.take(ids[0], ids[1], 1)
    it.step(120.0)
    assert not robot.orders and robot.vertex == ids[1]


def test_a_cancelled_goal_stops_it_where_it_is_and_no_order() -> None:
    it = world()
    robot = it.robots["robot_0"]
    SUBSCRIPTIONS["goal"][1](robot, placed(robot.pose.x + 20.0, robot.pose.y))
    it.step(8.0)
    before = robot.pose
    SUBSCRIPTIONS["goal_cancel"][1](robot, {"id": "another's"})
    it.step(1.0)
    assert robot.pose != before
    SUBSCRIPTIONS["goal_cancel"][1](robot, {"id": ""})
    before = robot.pose
    it.step(5.0)
    assert robot.pose == before
    ids = list(it.building.graph.vertices)
    robot.take(ids[0], ids[1], 1)
    it.step(1.0)
    SUBSCRIPTIONS["goal_cancel"][1](robot, {"id": ""})
    it.step(240.0)
    assert not robot.orders
