"""Poses set from outside, as amcl takes them."""

from typing import Any

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.nav2.world import Nav2World
from fleet_tui.simulator.navigating.poses import solid
from fleet_tui.simulator.navigating.set_up import SetUpDesk, by_hand
from fleet_tui.simulator.ros.ros2 import ROS2
from tests.support.navigating import robot


def message(frame: str = "map", **turn: float) -> dict[str, Any]:
    pose = solid(Pose(9.0, 9.0))
    pose["orientation"] |= turn
    return {"header": {"frame_id": frame}, "pose": {"pose": pose, "covariance": [0.0] * 36}}


def test_a_pose_becomes_the_belief_and_is_published() -> None:
    it = robot()
    topic, (_, take) = next(iter(by_hand({it.name: it}).items()))
    assert topic == "/robot_0/initialpose" and not it.localise()
    take(message())
    assert it.localise() and (it.estimate.x, it.estimate.y) == (9.0, 9.0) and not it.localise()


def test_a_foreign_frame_and_a_crooked_quaternion_are_dropped() -> None:
    it = robot()
    _, take = next(iter(by_hand({it.name: it}).values()))
    take(message("odom"))
    take(message(w=0.0))
    assert it.belief.misplaced is None


def test_services_localise_and_switch_mapping() -> None:
    world = Nav2World(1, 1, seed=1, quiet=True)
    desk = SetUpDesk(world, "find", "slam")
    it = world.robots["robot_0"]
    assert set(desk.services(ROS2)) == {
        f"/robot_0/{part}" for part in ("find", "slam", "request_nomotion_update")
    }
    it.place(Pose(9.0, 9.0))
    assert it.localise() and not it.localise()
    assert desk.answer("/robot_0/request_nomotion_update", {}) == {} and it.localise()
    assert it.belief.misplaced is not None
    assert desk.answer("/robot_0/find", {}) == {} and it.belief.misplaced is None
    assert desk.answer("/robot_0/slam", {"data": False}) == {"success": True, "message": ""}
    world.step(1.0)
    assert {topic for topic, _ in desk.news(ROS2)} == {"/robot_0/mode", "/map"}
    assert [topic.name for topic in desk.topics(1.0, ROS2)] == ["/map", "/robot_0/mode"]
    assert desk.answer("/robot_0/other", {}) is None
