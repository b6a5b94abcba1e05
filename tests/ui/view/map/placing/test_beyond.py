"""Robots off the map and out of view."""

import math

import pytest

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.robots import beyond
from fleet_tui.ui.view.map.scene import Scene, SceneRobot

At = tuple[int, int, str]
CAMERA = Camera.fit((400, 200), 60, 20)


def chips(
    *places: tuple[float, float], misplaced: bool = True, plain: bool = False
) -> list[tuple[int, int, str]]:
    robots = tuple(
        SceneRobot(f"r{n}", n, Pose(x, y), misplaced=misplaced) for n, (x, y) in enumerate(places, 1)
    )
    scene = Scene("f", MapFrame(0.05, 400, 200), robots=robots)
    return [chip[:3] for chip in beyond(CellOccupancy(60, 20), scene, CAMERA, plain)]


@pytest.mark.parametrize(
    ("x", "y", "chip"),
    [
        (-30.0, 5.0, (0, 10, "⇠1?")),
        (60.0, 5.0, (57, 10, "⇢1?")),
        (10.0, 90.0, (30, 0, "⇡1?")),
        (10.0, -90.0, (30, 19, "⇣1?")),
        (-30.0, -90.0, (0, 19, "⇠1?")),
    ],
)
def test_a_chip_at_the_edge_points_to_who_is_out_of_view(
    x: float, y: float, chip: tuple[int, int, str]
) -> None:
    assert chips((x, y)) == [chip]
    assert chips((x, y), plain=True)[0][2].isascii()


def test_who_is_in_view_or_well_placed_or_nowhere_has_none() -> None:
    assert chips((10.0, 5.0), (math.nan, 0.0)) == [] and chips((-30.0, 5.0), misplaced=False) == []


def test_of_two_at_the_same_edge_the_second_hides_none() -> None:
    assert len(chips((-30.0, 5.0), (-40.0, 5.0))) == 1
