"""Movement between two poses: jitter is none, and no robot drives as far as its localisation jumps."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.situation.movement import jump, moved, pace, progressed, strayed

POSES = st.builds(Pose, st.floats(-50, 50), st.floats(-50, 50), st.floats(-10, 10))


@pytest.mark.parametrize(
    ("other", "has_moved", "got_on"),
    [
        (Pose(0.04, 0.0), False, False),
        (Pose(0.06, 0.0), True, False),
        (Pose(0.0, 0.0, 0.2), True, False),
        (Pose(0.0, 0.0, math.tau), False, False),
        (Pose(0.15, 0.15), True, True),
    ],
)
def test_jitter_is_no_movement_and_turning_is_no_progress(other: Pose, has_moved: bool, got_on: bool) -> None:
    assert (moved(Pose(0.0, 0.0), other), progressed(Pose(0.0, 0.0), other)) == (has_moved, got_on)


@pytest.mark.parametrize(
    ("x", "seconds", "metres"),
    [
        (0.9, 0.0, None),
        (1.1, 0.1, 1.1),
        (3.0, 0.5, 3.0),
        (3.0, 1.0, None),
        (3.0, -0.5, 3.0),
        (400.0, 100.0, None),
    ],
)
def test_a_jump_is_farther_than_any_robot_drives(x: float, seconds: float, metres: float | None) -> None:
    assert jump(Pose(0.0, 0.0), Pose(x, 0.0), seconds) == metres


@pytest.mark.parametrize(
    ("other", "is_far"),
    [
        (Pose(0.9, 0.0), False),
        (Pose(1.1, 0.0), True),
        (Pose(0.0, 0.0, 0.9), False),
        (Pose(0.0, 0.0, 1.1), True),
        (Pose(0.0, 0.0, math.tau), False),
    ],
)
def test_a_metre_or_a_radian_needs_another_pose_of_the_localisation(other: Pose, is_far: bool) -> None:
    assert strayed(Pose(0.0, 0.0), other) is is_far


@given(POSES, POSES, st.floats(0.0, 100.0))
def test_there_and_back_are_the_same(one: Pose, other: Pose, seconds: float) -> None:
    assert moved(one, other) is moved(other, one) and not moved(one, one)
    assert jump(one, other, seconds) == jump(other, one, seconds)


def test_the_pace_is_that_of_driving_and_neither_of_standing_nor_of_a_jump() -> None:
    here = Pose(0.0, 0.0, 0.0)
    assert pace(None, here, here, 0.1) is None
    assert pace(None, here, Pose(0.1, 0.0, 0.0), 0.1) == 1.0
    assert pace(1.0, here, Pose(9.0, 0.0, 0.0), 0.1) == 1.0
    assert pace(1.0, here, Pose(2.0, 0.0, 0.0), 60.0) == 1.0
    smoothed = pace(1.0, here, Pose(0.2, 0.0, 0.0), 0.1)
    assert smoothed is not None and 1.0 < smoothed < 1.1
