"""Poses as messages of ROS, and back."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import flat, solid, stamped


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-3.14, 3.14))
def test_a_pose_comes_back_as_it_was(x: float, y: float, yaw: float) -> None:
    back = flat(solid(Pose(x, y, yaw)))
    assert (back.x, back.y, back.yaw) == pytest.approx((x, y, yaw), abs=1e-9)


def test_a_quaternion_of_zeros_turns_nothing() -> None:
    pose = solid(Pose(1.0, 2.0, 3.0)) | {"orientation": dict.fromkeys("xyzw", 0.0)}
    assert flat(pose) == Pose(1.0, 2.0, 0.0)


def test_a_pose_on_the_map_has_no_time() -> None:
    found = stamped(Pose(1.0, 2.0, math.pi))
    assert found["header"] == {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "map"}
    assert found["pose"]["orientation"]["z"] == pytest.approx(1.0)
