"""Poses set from outside, as amcl takes them."""

from typing import Any

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.poses import solid
from fleet_tui.simulator.navigating.set_up import initial_poses
from tests.support.navigating import robot


def message(frame: str = "map", **turn: float) -> dict[str, Any]:
    pose = solid(Pose(9.0, 9.0))
    pose["orientation"] |= turn
    return {"header": {"frame_id": frame}, "pose": {"pose": pose, "covariance": [0.0] * 36}}


def test_a_pose_becomes_the_belief_and_is_published() -> None:
    it = robot()
    ((topic, (_, take)),) = initial_poses({it.name: it}).items()
    assert topic == "/robot_0/initialpose" and not it.localise()
    take(message())
    assert it.localise() and (it.estimate.x, it.estimate.y) == (9.0, 9.0) and not it.localise()


def test_a_foreign_frame_and_a_crooked_quaternion_are_dropped() -> None:
    it = robot()
    ((_, (_, take)),) = initial_poses({it.name: it}).items()
    take(message("odom"))
    take(message(w=0.0))
    assert it.belief.misplaced is None
