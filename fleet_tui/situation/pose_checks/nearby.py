"""The best match of a scan with the map around a pose: poses on a lattice, coarse to fine."""

import math

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Pose
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.set_up.streams import Points
from fleet_tui.situation.pose_checks.distance_field import DistanceField, distance_field
from fleet_tui.situation.pose_checks.match import NEAR, Match, match

REACH = 5.0
"""Metres from the pose to the farthest one of the first round."""
STEP = 0.4
TURN = math.tau / 36
"""Metres and radians between the poses of the first round; each round halves them."""
ROUNDS = 5
KEPT = 150
"""Poses of a round around which the next one searches."""
BEAMS = 60
"""Beams compared in the rounds."""
FINALISTS = 12
"""Poses compared with all beams in the end."""

_AROUND = np.array([(x, y, turn) for x in (-1, 0, 1) for y in (-1, 0, 1) for turn in (-1, 0, 1)])

Lattice = NDArray[np.int64]
"""Shape (n, 3): steps along x and y, and counter-clockwise turns."""
Poses = NDArray[np.float64]
"""Shape (n, 3): x and y in metres, yaw in radians."""


def best_near(grid: OccupancyGrid, points: Points, pose: Pose) -> tuple[Pose, Match] | None:
    """Return the pose near this one, with any heading, at which a scan matches the map best; None if none is
    better. `points` are the ends of its beams in the robot's frame."""
    start, field = match(grid, points, pose), distance_field(grid)
    if start is None:
        return None
    poses = _finalists(field, points, pose)
    x, y, yaw = poses[np.argmin(_misfits(field, points, poses, NEAR))].tolist()
    found = Pose(x, y, math.remainder(yaw, math.tau))
    matched = match(grid, points, found)
    if matched is None or (matched.share, -matched.median) <= (start.share, -start.median):
        return None
    return found, matched


def _finalists(field: DistanceField, points: Points, pose: Pose) -> Poses:
    """Return the poses that the rounds end with, the best first."""
    some = points[:: math.ceil(len(points) / BEAMS)]
    start, steps, lattice = np.array((pose.x, pose.y, pose.yaw)), np.array((STEP, STEP, TURN)), _disc()
    for round_ in range(ROUNDS):
        if round_:
            lattice, steps = np.unique((2 * lattice[:, None] + _AROUND).reshape(-1, 3), axis=0), steps / 2
        lattice = lattice[np.argsort(_misfits(field, some, start + steps * lattice))[:KEPT]]
    return start + steps * lattice[:FINALISTS]


def _disc() -> Lattice:
    """Return the first round: the places within reach, each with all headings."""
    side = int(REACH / STEP)
    x, y, turn = np.mgrid[-side : side + 1, -side : side + 1, : round(math.tau / TURN)].reshape(3, -1)
    return np.stack((x, y, turn), axis=1)[np.hypot(x, y) * STEP <= REACH]


def _misfits(
    field: DistanceField, points: Points, poses: Poses, cap: float = math.inf
) -> NDArray[np.float32]:
    """Return the mean distance of the ends from occupied cells, at most `cap` for each, at each of the poses;
    infinite for a pose in a wall."""
    x, y, yaw = (poses[:, [column]] for column in range(3))
    cos, sin = np.cos(yaw), np.sin(yaw)
    ahead, left = points[:, 0], points[:, 1]
    ends = np.stack((x + cos * ahead - sin * left, y + sin * ahead + cos * left), axis=-1)
    distances = np.minimum(field.at(ends.reshape(-1, 2)), cap)
    misfits: NDArray[np.float32] = distances.reshape(len(poses), -1).mean(axis=1)
    misfits[field.at(poses[:, :2]) == 0] = math.inf
    return misfits
