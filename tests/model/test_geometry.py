"""Angles as the source has them, and pixels that find their way back to the world."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose, metres_from, yaw_of_quaternion

ANGLES = st.floats(-math.pi + 1e-3, math.pi - 1e-3)
METRES = st.floats(-1e4, 1e4)
FRAMES = st.builds(
    MapFrame,
    resolution=st.floats(0.01, 2.0),
    width=st.integers(1, 5000),
    height=st.integers(1, 5000),
    origin=st.builds(Pose, METRES, METRES, ANGLES),
    added=st.booleans(),
)


def as_the_source_has_it(z: float, w: float) -> float:
    """2*acos(w)*sign(z), normalised to -180..180 degrees."""
    yaw = 2.0 * math.acos(max(-1.0, min(1.0, w))) * math.copysign(1.0, z)
    return (yaw + math.pi) % (2.0 * math.pi) - math.pi


def apart(one: float, other: float) -> float:
    return abs(math.remainder(one - other, 2.0 * math.pi))


@given(ANGLES, st.booleans())
def test_yaw_agrees_with_the_source_on_planar_robots(yaw: float, other_sign: bool) -> None:
    sign = -1.0 if other_sign else 1.0
    z, w = sign * math.sin(yaw / 2), sign * math.cos(yaw / 2)
    assert apart(yaw_of_quaternion(0.0, 0.0, z, w), yaw) < 1e-6
    assert apart(yaw_of_quaternion(0.0, 0.0, z, w), as_the_source_has_it(z, w)) < 1e-6


@given(ANGLES, st.floats(0.01, 100.0))
def test_a_quaternion_need_not_be_a_unit_one(yaw: float, length: float) -> None:
    z, w = length * math.sin(yaw / 2), length * math.cos(yaw / 2)
    assert apart(yaw_of_quaternion(0.0, 0.0, z, w), yaw) < 1e-6


@given(ANGLES, st.floats(-0.5, 0.5))
def test_a_robot_on_a_ramp_keeps_its_yaw(yaw: float, pitch: float) -> None:
    """q = yaw about z, then pitch about y."""
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    assert apart(yaw_of_quaternion(-sy * sp, cy * sp, sy * cp, cy * cp), yaw) < 1e-6


@pytest.mark.parametrize("w", [0.0, 1e-9, math.nan, math.inf])
def test_no_rotation_at_all_is_refused(w: float) -> None:
    with pytest.raises(ValueError, match="quaternion"):
        yaw_of_quaternion(0.0, 0.0, 0.0, w)


@given(FRAMES, st.floats(0, 5000), st.floats(0, 5000))
def test_pixels_come_back(frame: MapFrame, column: float, row: float) -> None:
    there = frame.to_pixel(*frame.to_world(column, row))
    assert there == pytest.approx((column, row), abs=1e-3)


@given(FRAMES, METRES, METRES)
def test_one_metre_is_one_over_resolution_pixels(frame: MapFrame, x: float, y: float) -> None:
    here, there = frame.to_pixel(x, y), frame.to_pixel(x + 1.0, y)
    assert math.dist(here, there) == pytest.approx(1.0 / frame.resolution, rel=1e-3)


def test_the_origin_is_the_lower_left_corner_of_the_image() -> None:
    frame = MapFrame(0.5, 40, 20, Pose(-1.0, -2.0))
    assert frame.to_pixel(-1.0, -2.0) == pytest.approx((0.0, 20.0))
    assert frame.to_pixel(19.0, 8.0) == pytest.approx((40.0, 0.0))


def test_a_turned_map_turns_the_world_back() -> None:
    """px = R(-yaw) * (p - origin) / resolution: with a quarter turn, world y is image right."""
    frame = MapFrame(1.0, 10, 10, Pose(3.0, 4.0, math.pi / 2))
    assert frame.to_pixel(3.0, 6.0) == pytest.approx((2.0, 10.0))
    assert frame.to_pixel(2.0, 4.0) == pytest.approx((0.0, 9.0))


def test_the_sources_own_stack_adds_the_origin() -> None:
    added = MapFrame(1.0, 10, 10, Pose(3.0, 4.0), added=True)
    assert added.to_pixel(0.0, 0.0) == pytest.approx((3.0, 6.0))
    assert added.to_world(3.0, 6.0) == pytest.approx((0.0, 0.0))


@pytest.mark.parametrize(
    ("at", "metres"), [((2.0, 3.0), 3.0), ((-3.0, 4.0), 5.0), ((7.0, 0.0), 3.0), ((1.0, 0.0), 0.0)]
)
def test_a_line_is_as_far_as_its_nearest_place(at: tuple[float, float], metres: float) -> None:
    assert metres_from(at, (0.0, 0.0, 4.0, 0.0)) == pytest.approx(metres)
    assert metres_from(at, (0.0, 0.0, 0.0, 0.0)) == pytest.approx(math.hypot(*at))
