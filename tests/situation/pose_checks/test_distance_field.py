"""Distances to the nearest wall, against a search of every wall."""

import math

import numpy as np
import pytest

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid
from fleet_tui.model.occupancy import build_grid
from fleet_tui.situation.pose_checks.distance_field import FARTHEST, DistanceField, distance_field

RESOLUTION = 0.1
HERE = Pose(0.0, 0.0)


def grid(side: int = 300, walls: int = 40, origin: Pose = HERE, added: bool = False) -> OccupancyGrid:
    rng = np.random.default_rng(1)
    cells = np.full((side, side), FREE, np.uint8)
    cells[rng.integers(0, side, walls), rng.integers(0, side, walls)] = OCCUPIED
    return build_grid(MapFrame(RESOLUTION, side, side, origin, added), cells)


@pytest.mark.parametrize(
    ("origin", "added"), [(Pose(0.0, 0.0), False), (Pose(-7.0, 3.0, 0.4), False), (Pose(2.0, 1.0), True)]
)
def test_it_is_the_distance_to_the_nearest_wall(origin: Pose, added: bool) -> None:
    it = grid(origin=origin, added=added)
    walls = np.argwhere(it.levels[0] == OCCUPIED)
    cells = np.random.default_rng(2).integers(0, 300, (200, 2))
    points = np.array([it.frame.to_world(column + 0.5, row + 0.5) for row, column in cells])
    found = DistanceField(it).at(points)
    for (row, column), metres in zip(cells, found, strict=True):
        nearest = min(math.dist((row, column), wall) for wall in walls) * RESOLUTION
        assert abs(metres - min(nearest, FARTHEST)) < 0.02


def test_beyond_the_map_everything_is_far() -> None:
    points = np.array([[-1.0, 1.0], [1e6, 1e6], [np.nan, 0.0], [1.0, -0.01]])
    assert (DistanceField(grid()).at(points) == FARTHEST).all()


def test_a_map_has_its_distances_once() -> None:
    it = grid(20)
    assert distance_field(it) is distance_field(it)


def test_a_coarse_map_has_distances_too() -> None:
    cells = np.array([[OCCUPIED, FREE, FREE, FREE]], np.uint8)
    field = DistanceField(build_grid(MapFrame(5.0, 4, 1), cells))
    assert field.farthest == 5.0
    assert field.at(np.array([[2.0, 1.0], [7.0, 1.0], [17.0, 1.0]])).tolist() == [0.0, 5.0, 5.0]
