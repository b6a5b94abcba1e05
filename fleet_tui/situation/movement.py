"""Movement between two poses of a robot."""

import math

from fleet_tui.model.geometry import Pose

# Localisation jitter: a robot whose pose stays within these stands still.
STILL_WITHIN = 0.05
STILL_YAW = 0.1
# Metres of progress below which a robot stays at its place: turning on the spot is no progress.
PLACE_WITHIN = 0.2
# Metres along x or y, and metres per second, above which a robot did not drive: its localisation jumped.
JUMP_DISTANCE = 1.0
JUMP_SPEED = 5.0
# Seconds between two poses above which they tell no speed, those over which it is smoothed, and the metres
# per second above which a robot drives.
PACE_WITHIN = 2.0
PACE_OVER = 10.0
CRAWLS = 0.1
# Metres, and radians, before which every localisation gives another pose: amcl does after 0.25 and 0.2,
# slam_toolbox after 0.5 of both.
STRAYED = 1.0
STRAYED_YAW = 1.0
JUMPS_WITHIN = 10.0
"""Seconds for which a jump of a robot's pose counts."""


def moved(one: Pose, other: Pose) -> bool:
    """Tell whether it moved or turned by more than localisation jitter."""
    turned = abs(math.remainder(_turn(one) - _turn(other), math.tau))
    return _metres(one, other) > STILL_WITHIN or turned > STILL_YAW


def strayed(one: Pose, other: Pose) -> bool:
    """Tell whether its localisation must have given another pose between them."""
    turned = abs(math.remainder(_turn(one) - _turn(other), math.tau))
    return _metres(one, other) > STRAYED or turned > STRAYED_YAW


def progressed(one: Pose, other: Pose) -> bool:
    """Tell whether it made progress."""
    return _metres(one, other) > PLACE_WITHIN


def jump(one: Pose, other: Pose, seconds: float) -> float | None:
    """Return the metres between them, if no robot drives so far in that time."""
    if abs(one.x - other.x) < JUMP_DISTANCE and abs(one.y - other.y) < JUMP_DISTANCE:
        # True of nearly every pose: this runs for each of them.
        return None
    metres = _metres(one, other)
    return metres if metres > JUMP_SPEED * abs(seconds) else None


def pace(before: float | None, one: Pose, other: Pose, seconds: float) -> float | None:
    """Return the usual speed of a robot in m/s after one more step; while it stands or jumps `before`, None
    if it never drove."""
    if not 0.0 < seconds <= PACE_WITHIN:
        return before
    speed = _metres(one, other) / seconds
    if not CRAWLS < speed < JUMP_SPEED:
        return before
    return speed if before is None else before + (speed - before) * min(1.0, seconds / PACE_OVER)


def _metres(one: Pose, other: Pose) -> float:
    return math.dist((one.x, one.y), (other.x, other.y))


def _turn(pose: Pose) -> float:
    return math.remainder(pose.yaw, math.tau)
