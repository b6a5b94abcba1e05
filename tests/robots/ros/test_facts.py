"""Facts of the common ROS packages: numbers that can be true, and words for those that can not."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.robots.ros.facts import FARTHEST, frame_of, is_place, pose_of
from fleet_tui.robots.ros.messages import MapMetadata, Point, Quaternion, RosPose
from fleet_tui.text.errors import WireError


def ros_pose(x: float, y: float, yaw: float = 0.0) -> RosPose:
    return RosPose(Point(x, y), Quaternion(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))


@given(st.floats())
def test_a_place_is_finite_and_within_any_site(number: float) -> None:
    assert is_place(0.0, number) is (abs(number) <= FARTHEST)


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(-3.1, 3.1), st.sampled_from([1.0, 0.001]))
def test_a_pose_keeps_its_heading_and_takes_the_scale(x: float, y: float, yaw: float, scale: float) -> None:
    found = pose_of(ros_pose(x, y, yaw), "pose", scale)
    assert (found.x, found.y) == (x * scale, y * scale)
    assert found.yaw == pytest.approx(yaw, abs=1e-9)


@pytest.mark.parametrize("bad", [math.nan, math.inf, 2 * FARTHEST])
def test_a_place_that_is_none_is_named_with_its_field(bad: float) -> None:
    with pytest.raises(WireError, match=r"goal\.position is not a finite number"):
        pose_of(ros_pose(bad, 0.0), "goal")


def test_a_map_whose_turn_was_never_set_is_not_turned() -> None:
    unset = RosPose(Point(1.0, 2.0), Quaternion(0.0, 0.0, 0.0, 0.0))
    assert frame_of(MapMetadata(0.05, 4, 3, unset), added=False).origin == Pose(1.0, 2.0)


@pytest.mark.parametrize("resolution", [0.0, -0.05, math.nan, math.inf])
def test_a_map_without_a_sensible_resolution_is_refused(resolution: float) -> None:
    with pytest.raises(WireError):
        frame_of(MapMetadata(resolution, 4, 3, ros_pose(0.0, 0.0)), added=False)
