"""Poses set from outside, as amcl takes them, and the services of set-up."""

from typing import Any

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import solid
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2

TOPIC = "/robot_0/initialpose"


def message(frame: str = "map", **turn: float) -> dict[str, Any]:
    pose = solid(Pose(9.0, 9.0))
    pose["orientation"] |= turn
    return {"header": {"frame_id": frame}, "pose": {"pose": pose, "covariance": [0.0] * 36}}


def made() -> Nav2Fleet:
    return Nav2Fleet(1, 1, seed=1, quiet=True)


def test_a_pose_becomes_the_belief_and_is_published() -> None:
    fleet = made()
    it, (_, take) = fleet.robots["robot_0"], fleet.subscriptions()[TOPIC]
    assert not it.localise()
    take(message())
    assert it.localise() and (it.estimate.x, it.estimate.y) == (9.0, 9.0) and not it.localise()


def test_a_foreign_frame_and_a_crooked_quaternion_are_dropped() -> None:
    fleet = made()
    _, take = fleet.subscriptions()[TOPIC]
    take(message("odom"))
    take(message(w=0.0))
    assert fleet.robots["robot_0"].belief.misplaced is None


def test_services_localise_and_switch_mapping() -> None:
    fleet = made()
    it = fleet.robots["robot_0"]
    list(fleet.news(ROS2))
    settle, find, slam = (
        f"/robot_0/{part}"
        for part in ("request_nomotion_update", fleet.localise_service, fleet.mapping_service)
    )
    assert {settle, find, slam} <= fleet.services(ROS2).keys()
    it.place(Pose(9.0, 9.0))
    assert it.localise() and not it.localise()
    assert fleet.answer(settle, {}) == {} and it.localise()
    assert it.belief.misplaced is not None
    assert fleet.answer(find, {}) == {} and it.belief.misplaced is None
    assert it.localise()
    assert fleet.answer(slam, {"data": False}) == {"success": True, "message": ""}
    fleet.step(1.0)
    assert {topic for topic, _ in fleet.news(ROS2)} == {"/robot_0/mode", "/map"}
