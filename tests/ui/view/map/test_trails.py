"""The points of a trail: half a metre apart, a minute long, limited in number."""

import math
from dataclasses import replace
from itertools import pairwise

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.map.trails import POINTS, SECONDS, STEP, Trails

EMPTY = Scene("floor_0", MapFrame(0.05, 400, 200))


def at(second: float, x: float, floor: str = "floor_0", online: bool = True) -> Scene:
    return replace(EMPTY, floor=floor, at=second, robots=(SceneRobot("r", 1, Pose(x, 0.0), online=online),))


def told(*scenes: Scene) -> Trails:
    trails = Trails()
    for scene in scenes:
        trails.note(scene)
    return trails


def test_a_point_for_every_half_metre_or_little_more_with_its_age() -> None:
    trails = told(*(at(n / 10, n / 10) for n in range(51)))  # five metres in five seconds
    points = trails.of(at(6.0, 5.0))
    assert 8 <= len(points) <= 11
    assert points[:, 2].max() == 6.0
    gaps = sorted(points[:, 0])
    assert all(b - a >= STEP for a, b in pairwise(gaps))


def test_a_robot_that_stands_leaves_one_point_and_after_a_minute_none() -> None:
    trails = told(*(at(n / 10, 3.0) for n in range(20)))
    assert len(trails.of(at(2.0, 3.0))) == 1
    assert len(trails.of(at(SECONDS + 1.0, 3.0))) == 0


def test_each_floor_has_its_own() -> None:
    trails = told(at(0.0, 1.0), at(1.0, 5.0, "floor_1"))
    assert trails.of(at(1.0, 0.0))[:, 0].tolist() == [1.0]
    assert trails.of(at(1.0, 0.0, "floor_1"))[:, 0].tolist() == [5.0]
    assert len(trails.of(at(1.0, 0.0, "attic"))) == 0


def test_however_it_jumps_a_robot_keeps_a_bounded_number_of_points() -> None:
    trails = told(*(at(n / 4, n * 7.0) for n in range(3 * POINTS)))
    points = trails.of(at(3 * POINTS / 4, 0.0))
    assert len(points) == POINTS
    assert points[:, 0].max() == (3 * POINTS - 1) * 7.0


def test_what_is_nowhere_or_offline_leaves_nothing() -> None:
    assert len(told(at(0.0, math.nan), at(1.0, math.inf), at(2.0, 1.0, online=False)).of(at(3.0, 0.0))) == 0
