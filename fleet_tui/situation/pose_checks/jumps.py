"""Jumps of a pose that no drive explains: localisation found the robot elsewhere."""

import math
from itertools import pairwise

from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.situation.movement import JUMPS_WITHIN
from fleet_tui.text.language import EMPTY, Message

JUMP = 0.5
JUMP_TURN = math.radians(30.0)
"""Metres and radians beyond what speed explains."""
FASTEST = 3.0
FASTEST_TURN = math.radians(180.0)
"""Metres and radians a second that no robot here exceeds."""
APART = 0.35
STEPS = 4
"""Seconds from which two jumps are apart, and jumps in a row, each for itself, from which they are steps."""
JUMPS = 2
"""This many jumps within JUMPS_WITHIN seconds are more than corrections."""


def recent_jumps(robot: Robot, now: float) -> tuple[Reading[float], ...]:
    """Return the jumps of a robot's pose in the last JUMPS_WITHIN seconds, none if they may be corrections:
    its pose then means nothing, and is no movement. `now` is monotonic."""
    recent = tuple(jump for jump in robot.jumps if now - jump.at < JUMPS_WITHIN)
    return recent if len(recent) >= JUMPS else ()


def is_jumping(robot: Robot, now: float) -> bool:
    """Tell whether a robot's pose jumps now and then, and so is no movement. Where every pose is a step no
    robot makes, it drives in a simulator's faster time."""
    if not robot.jumps:  # nearly always: this is asked of every robot in every tick
        return False
    times = [jump.at for jump in recent_jumps(robot, now)]
    gaps = [later - earlier >= APART for earlier, later in pairwise(times)]
    return sum(gaps) >= JUMPS - 1 and sum(gaps) * STEPS > len(gaps)


def pose_jump(before: Pose, after: Pose, seconds: float) -> Message:
    """Return the jump between two poses in words, empty if the robot may have driven that far."""
    elapsed = max(0.0, seconds)
    metres = math.dist((before.x, before.y), (after.x, after.y))
    turns = math.remainder(before.yaw, math.tau), math.remainder(after.yaw, math.tau)
    turn = abs(math.remainder(turns[0] - turns[1], math.tau))
    if metres <= JUMP + FASTEST * elapsed and turn <= min(JUMP_TURN + FASTEST_TURN * elapsed, math.pi):
        return EMPTY
    return Message("{metres} m and {degrees}°", metres=f"{metres:.1f}", degrees=f"{math.degrees(turn):.0f}")
