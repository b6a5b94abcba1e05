"""Outlines of robots of known size."""

from dataclasses import replace

import numpy as np
import pytest

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene, SceneRobot

FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 80, 22)
SCENE = Scene("f", FRAME)


def drawn(scene: Scene, camera: Camera = CAMERA) -> Cells:
    return picture(backdrop(scene, camera, MapOptions()), scene, camera, MapOptions())


@pytest.mark.parametrize(("yaw", "wide", "high"), [(0.0, 2.0, 1.0), (np.pi / 2, 1.0, 2.0)])
def test_a_robot_of_known_size_has_its_outline_to_scale_when_seen_from_near(
    yaw: float, wide: float, high: float
) -> None:
    robot = SceneRobot("robot_0", 1, Pose(6.0, 5.0, yaw), size=(2.0, 1.0))
    near = CAMERA.zoomed(4.0, FRAME.to_pixel(6.0, 5.0))
    before, after = (
        drawn(replace(SCENE, robots=(one,)), camera=near) for one in (robot._replace(size=None), robot)
    )
    rows, columns = np.nonzero(before.codes != after.codes)
    dot = near.scale * FRAME.resolution
    assert (columns.max() - columns.min() + 1) * 2 * dot == pytest.approx(wide, abs=4 * dot)
    assert (rows.max() - rows.min() + 1) * 4 * dot == pytest.approx(high, abs=8 * dot)


def test_from_far_no_outline_is_drawn_and_one_that_is_nowhere_breaks_nothing() -> None:
    robot = SceneRobot("robot_0", 1, Pose(6.0, 5.0), size=(0.4, 0.3))
    with_size, without = (drawn(replace(SCENE, robots=(one,))) for one in (robot, robot._replace(size=None)))
    assert with_size.text() == without.text()
    nowhere = robot._replace(pose=Pose(float("nan"), 1.0, float("inf")), size=(9.0, 9.0))
    assert drawn(replace(SCENE, robots=(nowhere,))).text() == drawn(SCENE).text()
