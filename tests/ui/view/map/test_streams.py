"""The layers of the laser scan and of the planned path."""

import math
from dataclasses import replace

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.roles import StyleRole

FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 100, 29)
SCENE = Scene("f", FRAME)


def drawn(scene: Scene, look: MapOptions | None = None) -> Cells:
    look = look or MapOptions()
    return picture(backdrop(scene, CAMERA, look), scene, CAMERA, look)


def cell(x: float, y: float) -> tuple[int, int]:
    column, row = CAMERA.to_cell(*FRAME.to_pixel(x, y))
    return row, column


def test_beams_end_where_the_robot_sees_them_from_its_pose() -> None:
    beams = np.array([[2.0, 0.0], [0.0, 1.0], [math.nan, 0.0], [1e30, 1.0]], np.float32)
    cells = drawn(replace(SCENE, beams=beams, beams_at=Pose(10.0, 5.0, math.pi / 2)))
    assert cells.roles[cell(10.0, 7.0)] == StyleRole.SCAN
    assert cells.roles[cell(9.0, 5.0)] == StyleRole.SCAN
    assert np.count_nonzero(cells.roles == StyleRole.SCAN) == 2


def test_beams_of_an_uncertain_pose_are_dim_and_without_a_pose_nothing_is_drawn() -> None:
    beams = np.array([[2.0, 0.0]], np.float32)
    old = drawn(replace(SCENE, beams=beams, beams_at=Pose(10.0, 5.0), beams_are_old=True))
    assert StyleRole.TRAIL in old.roles and StyleRole.SCAN not in old.roles
    assert StyleRole.SCAN not in drawn(replace(SCENE, beams=beams)).roles


def test_a_wall_on_which_beams_end_stays_a_wall_in_their_colour() -> None:
    classes = np.full((200, 400), FREE, np.uint8)
    classes[:, 240:260] = OCCUPIED
    scene = replace(SCENE, grid=build_grid(FRAME, classes))
    seen = replace(scene, beams=np.array([[2.3, 0.0], [1.0, 0.0]], np.float32), beams_at=Pose(10.0, 5.0))
    for drawing in Drawing:
        before, after = (drawn(one, MapOptions(drawing)) for one in (scene, seen))
        wall, ground = cell(12.3, 5.0), cell(11.0, 5.0)
        assert after.codes[wall] == before.codes[wall] and after.codes[ground] != before.codes[ground]
        assert after.roles[wall] == after.roles[ground] == StyleRole.SCAN


def test_a_path_is_a_line_of_its_points() -> None:
    path = np.array([[2.0, 5.0], [2.0001, 5.0], [18.0, 5.0]], np.float32)
    cells = drawn(replace(SCENE, path=path))
    assert all(cells.roles[cell(x, 5.0)] == StyleRole.MISSION_NEXT for x in (3.0, 10.0, 17.0))
    for few in (path[:1], path[:0]):
        assert StyleRole.MISSION_NEXT not in drawn(replace(SCENE, path=few)).roles


def test_ascii_has_characters_of_its_own() -> None:
    beams, path = np.array([[2.0, 0.0]], np.float32), np.array([[2.0, 2.0], [18.0, 2.0]], np.float32)
    scene = replace(SCENE, beams=beams, beams_at=Pose(10.0, 5.0), path=path)
    text = drawn(scene, MapOptions(Drawing.ASCII)).text()
    assert text.count("%") == 1 and text.count(":") > 20 and text.isascii()
