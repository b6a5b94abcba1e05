"""Fixed frames of a robot, and the place of one on another: where its laser is mounted."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from fleet_tui.model.geometry import Pose

BASES = ("base_link", "base_footprint")
"""Usual frames of a robot, the first that there is."""
TILTED = 0.9
"""Cosine of the tilt above which a laser scans another plane than the ground's: 26 degrees."""

Vector = tuple[float, float, float]
Turn = tuple[float, float, float, float]
"""A unit quaternion: x, y, z, w."""


class Transform(NamedTuple):
    """A frame in its parent: metres, and a rotation."""

    parent: str
    at: Vector
    turn: Turn


Frames = Mapping[str, Transform]
"""Transforms by the name of the frame."""


class Mount(NamedTuple):
    """The place of a laser on its robot. A flipped one hangs upside down."""

    pose: Pose
    is_flipped: bool = False


def mount_of(frames: Frames, base: str, laser: str) -> Mount | None:
    """Return the place of the frame `laser` on the robot, None if no chain of transforms joins them or the
    laser is tilted. `base` is the robot's frame, which may have any prefix; empty for a usual one."""
    to_laser = _to_root(frames, laser)
    for name in [base] if base else BASES:
        for frame in {laser, *frames, *(one.parent for one in frames.values())}:
            if frame == name or frame.endswith(f"/{name}"):
                to_base = _to_root(frames, frame)
                if to_base.parent == to_laser.parent:
                    return _mount(to_base, to_laser)
    return None


def _to_root(frames: Frames, frame: str) -> Transform:
    """Return a frame in the root of its tree."""
    found, seen = Transform(frame, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)), set[str]()
    while (step := frames.get(found.parent)) is not None and found.parent not in seen:
        seen.add(found.parent)
        at = _added(step.at, _turned(step.turn, found.at))
        found = Transform(step.parent, at, _product(step.turn, found.turn))
    return found


def _mount(base: Transform, laser: Transform) -> Mount | None:
    x, y, z, w = base.turn
    back: Turn = (-x, -y, -z, w)
    apart = (laser.at[0] - base.at[0], laser.at[1] - base.at[1], laser.at[2] - base.at[2])
    at, turn = _turned(back, apart), _product(back, laser.turn)
    up, ahead = _turned(turn, (0.0, 0.0, 1.0)), _turned(turn, (1.0, 0.0, 0.0))
    if abs(up[2]) < TILTED:
        return None
    return Mount(Pose(at[0], at[1], math.atan2(ahead[1], ahead[0])), up[2] < 0.0)


def _added(one: Vector, other: Vector) -> Vector:
    return one[0] + other[0], one[1] + other[1], one[2] + other[2]


def _product(one: Turn, other: Turn) -> Turn:
    (x, y, z, w), (a, b, c, d) = one, other
    return (
        w * a + x * d + y * c - z * b,
        w * b - x * c + y * d + z * a,
        w * c + x * b - y * a + z * d,
        w * d - x * a - y * b - z * c,
    )


def _turned(turn: Turn, point: Vector) -> Vector:
    x, y, z, w = turn
    found = _product(_product(turn, (*point, 0.0)), (-x, -y, -z, w))
    return found[0], found[1], found[2]
