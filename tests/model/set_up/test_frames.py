"""The place of a laser by static transforms: chains, prefixes, turned and flipped ones."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.frames import Frames, Mount, Transform, Turn, mount_of

Angle = st.floats(-3.0, 3.0)
Metres = st.floats(-5.0, 5.0)


def turned(roll: float = 0.0, yaw: float = 0.0, pitch: float = 0.0) -> Turn:
    """A rotation by roll, then pitch, then yaw."""
    (sr, cr), (sp, cp), (sy, cy) = ((math.sin(a / 2), math.cos(a / 2)) for a in (roll, pitch, yaw))
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def near(found: Mount | None, pose: Pose, flipped: bool = False) -> bool:
    assert found is not None
    turn = math.remainder(found.pose.yaw - pose.yaw, math.tau)
    same = math.dist((found.pose.x, found.pose.y), (pose.x, pose.y)) < 1e-6 and abs(turn) < 1e-6
    return same and found.is_flipped is flipped


@given(Metres, Metres, Angle, Metres, Metres, Angle)
def test_a_chain_is_walked_along(x: float, y: float, yaw: float, a: float, b: float, turn: float) -> None:
    frames = {
        "mast": Transform("base_link", (x, y, 0.3), turned(yaw=yaw)),
        "laser": Transform("mast", (a, b, 1.0), turned(yaw=turn)),
    }
    assert near(mount_of(frames, "", "laser"), Pose(x, y, yaw).after(Pose(a, b, turn)))


@given(Angle, Angle)
def test_a_roll_of_half_a_turn_is_a_flipped_laser(yaw: float, turn: float) -> None:
    frames = {
        "mast": Transform("base_link", (1.0, 0.0, 0.0), turned(yaw=yaw)),
        "laser": Transform("mast", (0.5, 0.25, 0.0), turned(roll=math.pi, yaw=turn)),
    }
    wanted = Pose(1.0, 0.0, yaw).after(Pose(0.5, 0.25, turn))
    assert near(mount_of(frames, "", "laser"), wanted, flipped=True)
    upright = frames | {"scan": Transform("laser", (0.0, 0.0, 0.0), turned(roll=math.pi))}
    assert near(mount_of(upright, "", "scan"), wanted)


def test_the_base_may_be_above_beside_or_have_a_prefix() -> None:
    frames: Frames = {
        "r/base_link": Transform("r/base_footprint", (0.0, 0.0, 0.1), turned()),
        "r/laser": Transform("r/base_link", (0.2, 0.0, 0.0), turned()),
        "r/base": Transform("r/base_footprint", (1.0, 0.0, 0.0), turned(yaw=math.pi)),
    }
    assert near(mount_of(frames, "", "r/laser"), Pose(0.2, 0.0))
    assert near(mount_of(frames, "base", "r/laser"), Pose(0.8, 0.0, math.pi))
    assert near(mount_of(frames, "r/base", "r/laser"), Pose(0.8, 0.0, math.pi))
    assert near(mount_of({}, "base_scan", "base_scan"), Pose(0.0, 0.0))


TILTED = Transform("base_link", (0.0, 0.0, 0.0), turned(pitch=math.pi / 2))


@pytest.mark.parametrize(
    "frames",
    [{}, {"laser": Transform("mast", (0.0, 0.0, 0.0), turned())}, {"laser": TILTED}],
    ids=["nothing", "no way to the base", "a laser that looks up"],
)
def test_without_a_place_on_the_ground_there_is_none(frames: Frames) -> None:
    assert mount_of(frames, "", "laser") is None


def test_a_ring_of_frames_has_an_end() -> None:
    here = (0.0, 0.0, 0.0)
    ring = {"laser": Transform("mast", here, turned()), "mast": Transform("laser", here, turned())}
    assert mount_of(ring, "base", "laser") is None
