"""The fitted view shows what is known, not the image around it."""

from dataclasses import replace

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, UNKNOWN, build_grid
from fleet_tui.ui.view.map.area import MARGIN, STEP, worth_seeing
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex

FRAME = MapFrame(0.05, 2000, 1200)
M = 20
"""Pixels per metre."""


def scene(rows: slice = slice(500, 700), columns: slice = slice(900, 1100)) -> Scene:
    classes = np.full((1200, 2000), UNKNOWN, np.uint8)
    classes[rows, columns] = FREE
    return Scene("f", FRAME, build_grid(FRAME, classes))


def robot(x: float, y: float) -> SceneRobot:
    return SceneRobot("r", 1, Pose(x, y))


def test_the_area_is_around_the_known_cells_with_a_margin() -> None:
    assert worth_seeing(scene(), ()) == (
        900 - MARGIN * M,
        500 - MARGIN * M,
        1100 + MARGIN * M,
        700 + MARGIN * M,
    )


def test_without_a_known_cell_it_is_the_whole_map_and_without_a_map_none() -> None:
    assert worth_seeing(scene(slice(0, 0)), ()) == (0, 0, 2000, 1200)
    assert worth_seeing(Scene("f", FRAME), ()) is None


def test_vertices_on_unknown_ground_are_in_it() -> None:
    area = worth_seeing(replace(scene(), vertices=(SceneVertex("1", 90.0, 58.0),)), ())
    assert area == (900 - MARGIN * M, 40 - MARGIN * M, 1800 + MARGIN * M, 700 + MARGIN * M)


def test_a_robot_outside_extends_it_in_steps_also_near_the_map_and_one_far_off_does_not() -> None:
    still = worth_seeing(scene(), ())
    assert worth_seeing(scene(), [robot(50.0, 30.0), robot(5000.0, 30.0), robot(float("nan"), 1.0)]) == still
    one, beside = (worth_seeing(scene(), [robot(x, 30.0)]) for x in (71.0, 73.0))
    assert one == beside
    assert one is not None
    assert one[2] == 75.0 * M
    beside_the_map = worth_seeing(scene(), [robot(-6.0, 30.0)])
    assert beside_the_map is not None and beside_the_map[0] == -10.0 * M
    assert STEP == 5.0
