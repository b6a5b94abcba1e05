"""The speed of a robot that is driven by hand: up slowly, down at once, and never above its caps."""

import math

from msgspec import Struct

from fleet_tui.commands.driving.hold import Hand
from fleet_tui.model.set_up.driving import STILL, Axis, Speeds

FIRST = 1 / 3
"""The share of the caps with which a drive begins."""
STEP = 1 / 6
LEAST = 1 / 6
"""The change of that share by one key, and its least value."""
RISE = 0.5
"""Metres per second that each second adds; turning rises in the same proportion to its cap."""
SLOW_WITHIN = 0.5
CREEP = 0.05
"""Metres of free floor ahead below which it slows down, and the metres per second that are always left: a
robot has to be driven out of a corner, too."""


class Caps(Struct, frozen=True):
    """The most that is ever sent, in metres and radians per second, in both directions."""

    linear: float = 0.3
    angular: float = 0.6


def faster(share: float, steps: int) -> float:
    """Return the share of the caps after so many steps, from LEAST to 1."""
    return min(max(share + steps * STEP, LEAST), 1.0)


def wanted(hand: Hand, at: float, share: float, caps: Caps) -> Speeds:
    """Return the speeds that the held keys ask for."""
    signs = hand.signs(at)
    ahead, sideways, turning = (signs.get(axis, 0) * share for axis in Axis)
    return Speeds(ahead * caps.linear, sideways * caps.linear, turning * caps.angular)


def slowed(speeds: Speeds, clearance: float) -> Speeds:
    """Return speeds for `clearance` metres of free floor ahead of the footprint; turning is not slowed."""
    share = min(max(clearance, 0.0) / SLOW_WITHIN, 1.0)
    linear = speeds.linear
    if share == 1.0 or linear <= CREEP:
        return speeds
    factor = max(share, CREEP / linear)
    return Speeds(speeds.ahead * factor, speeds.sideways * factor, speeds.turning)


def next_speeds(before: Speeds, target: Speeds, seconds: float, caps: Caps) -> Speeds:
    """Return the speeds to send `seconds` after the last ones: capped last. A target that is not finite is a
    stop."""
    if not all(map(math.isfinite, target)):
        return STILL
    turning = RISE * caps.angular / caps.linear if caps.linear > 0 else RISE
    rises = (RISE * seconds, RISE * seconds, turning * seconds)
    steps = (_towards(*one) for one in zip(before, target, rises, strict=True))
    return capped(Speeds(*steps), caps)


def capped(speeds: Speeds, caps: Caps) -> Speeds:
    """Return speeds within the caps; the direction stays."""
    linear = speeds.linear
    factor = min(1.0, caps.linear / linear) if linear > 0 else 0.0
    turning = min(max(speeds.turning, -caps.angular), caps.angular)
    return Speeds(speeds.ahead * factor, speeds.sideways * factor, turning)


def _towards(before: float, target: float, rise: float) -> float:
    """Return the next value: down at once, up by `rise` at most, and through zero on the way back."""
    start = before if before * target > 0 else 0.0
    if abs(target) <= abs(start):
        return target
    return math.copysign(min(abs(start) + rise, abs(target)), target)
