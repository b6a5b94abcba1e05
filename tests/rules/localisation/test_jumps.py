"""Jumps of a pose that speed can't explain."""

import math

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.rules.localisation.jumps import pose_jump

HERE = Pose(1.0, 2.0, 3.0)


def test_a_drive_is_no_jump() -> None:
    assert pose_jump(HERE, HERE.after(Pose(0.3, 0.0, 0.2)), 0.1) == ""
    assert pose_jump(HERE, HERE.after(Pose(3.0, 0.0, 0.0)), 1.0) == ""
    assert pose_jump(HERE, Pose(1.0, 2.0, -3.0), 0.1) == "", "it turned the short way"


def test_a_jump_is_named() -> None:
    assert pose_jump(HERE, HERE.after(Pose(2.0, 0.0, 0.0)), 0.1) == "2.0 m and 0°"
    assert pose_jump(HERE, HERE.after(Pose(0.0, 0.0, math.pi / 2)), 0.1) == "0.0 m and 90°"


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0.0, 1e6))
def test_any_two_poses_are_compared(x: float, yaw: float, other: float, seconds: float) -> None:
    assert pose_jump(Pose(x, 0.0, yaw), Pose(x, 0.0, yaw), seconds) == ""
    pose_jump(Pose(x, 0.0, yaw), Pose(other, 0.0, other), seconds)
