"""The ends of a scan's beams in the robot's frame."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray

from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.streams import LaserScan, beams_of, placed

Ranges = NDArray[np.float32]


def scan(*ranges: float, step: float = math.pi / 2) -> LaserScan:
    return LaserScan(np.array(ranges, np.float32), 0.0, step, 0.1, 10.0, "laser", None)


def test_beams_are_in_the_frame_of_the_robot() -> None:
    found = beams_of(scan(1.0, 2.0), Pose(0.5, 0.0, math.pi / 2))
    assert np.allclose(found.points, [[0.5, 1.0], [-1.5, 0.0]], atol=1e-6)
    assert (found.sent, found.is_mounted) == (2, True)


def test_a_flipped_laser_turns_clockwise() -> None:
    assert np.allclose(beams_of(scan(1.0, 2.0), None, True).points, [[1.0, 0.0], [0.0, -2.0]], atol=1e-6)
    assert not beams_of(scan(1.0), None).is_mounted


def test_what_hits_nothing_is_skipped() -> None:
    found = beams_of(scan(math.nan, math.inf, 0.05, 10.5, -1.0, 3.0), None)
    assert len(found.points) == 1 and found.sent == 6


@given(arrays(np.float32, st.integers(0, 50)), st.floats(-7.0, 7.0), st.booleans())
def test_any_ranges_give_finite_points(ranges: Ranges, step: float, flipped: bool) -> None:
    found = beams_of(LaserScan(ranges, 0.0, step, 1e-6, 1e9, "", None), None, flipped)
    assert np.isfinite(found.points).all() and len(found.points) <= found.sent


@given(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-10.0, 10.0))
def test_points_are_placed_as_a_pose_is(x: float, y: float, yaw: float) -> None:
    at = Pose(x, y, yaw)
    ((px, py),) = placed(np.array([[3.0, -1.0]], np.float32), at)
    wanted = at.after(Pose(3.0, -1.0))
    assert math.isclose(px, wanted.x, abs_tol=1e-3) and math.isclose(py, wanted.y, abs_tol=1e-3)
