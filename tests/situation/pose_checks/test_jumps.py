"""Jumps of a pose that speed can't explain."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading
from fleet_tui.situation.pose_checks.jumps import is_jumping, pose_jump
from tests.support.fleets import R0, fleet

HERE = Pose(1.0, 2.0, 3.0)


def test_a_drive_is_no_jump() -> None:
    assert pose_jump(HERE, HERE.after(Pose(0.3, 0.0, 0.2)), 0.1) == ""
    assert pose_jump(HERE, HERE.after(Pose(3.0, 0.0, 0.0)), 1.0) == ""
    assert pose_jump(HERE, Pose(1.0, 2.0, -3.0), 0.1) == "", "it turned the short way"


@pytest.mark.parametrize(
    ("times", "jumps"),
    [
        ([], False),
        ([1.0], False),
        ([1.0, 1.1], False),
        ([1.0, 2.0], True),
        ([n / 2 for n in range(20)], True),
        ([1.0, 1.1, 3.0, 3.1, 5.0, 5.1], True),
        ([n / 10 for n in range(100)], False),
        ([*(n / 10 for n in range(40)), *(6.0 + n / 10 for n in range(30))], False),
    ],
)
def test_jumps_now_and_then_mean_that_it_jumps_steps_at_every_pose_do_not(
    times: list[float], jumps: bool
) -> None:
    robot = replace(fleet().robots[R0], jumps=tuple(Reading(3.0, at) for at in times))
    assert is_jumping(robot, 9.9) is jumps


def test_a_jump_is_named() -> None:
    assert pose_jump(HERE, HERE.after(Pose(2.0, 0.0, 0.0)), 0.1) == "2.0 m and 0°"
    assert pose_jump(HERE, HERE.after(Pose(0.0, 0.0, math.pi / 2)), 0.1) == "0.0 m and 90°"


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0.0, 1e6))
def test_any_two_poses_are_compared(x: float, yaw: float, other: float, seconds: float) -> None:
    assert pose_jump(Pose(x, 0.0, yaw), Pose(x, 0.0, yaw), seconds) == ""
    pose_jump(Pose(x, 0.0, yaw), Pose(other, 0.0, other), seconds)
