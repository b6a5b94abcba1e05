"""A small hall with robots, drawn."""

import math

import numpy as np

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex

WIDTH, HEIGHT = 64, 20


def hall() -> OccupancyGrid:
    """12 x 7.6 m: a hall with a dividing wall, two racks and unknown ground at the right."""
    classes = np.full((152, 240), FREE, np.uint8)
    classes[:, 210:] = UNKNOWN
    classes[4:-4, 4] = classes[4:-4, 209] = OCCUPIED
    classes[4, 4:210] = classes[-5, 4:210] = OCCUPIED
    classes[4:90, 90] = OCCUPIED
    classes[30:46, 120:180] = classes[80:96, 120:180] = OCCUPIED
    return build_grid(MapFrame(0.05, 240, 152), classes)


VERTICES = (
    SceneVertex("1", 1.5, 6.2, label="Base"),
    SceneVertex("2", 9.5, 2.2, label="Consumidores"),
    SceneVertex("3", 1.5, 1.2, Role.DOCKING, "Dock"),
    SceneVertex("4", 7.2, 4.6, Role.ELEVATOR, "仓库"),
    SceneVertex("5", 3.0, 2.2),
    SceneVertex("6", 5.2, 2.2),
)
EDGES = ((1.5, 6.2, 3.0, 2.2), (1.5, 1.2, 3.0, 2.2), (3.0, 2.2, 5.2, 2.2), (5.2, 2.2, 9.5, 2.2))
ROBOTS = (
    SceneRobot("robot_0", 1, Pose(2.47, 4.04, -1.2), mark="1", cargo=True, selected=True),
    SceneRobot("robot_1", 2, Pose(6.0, 2.3, math.pi), mark="2", obstacle=True),
    SceneRobot("robot_2", 3, Pose(6.1, 2.3, 0.8), mark="3", paused=True, cargo=True),
    SceneRobot("robot_3", 4, Pose(7.23, 6.62, math.pi / 2), mark="4", online=False, age=41.2),
    SceneRobot("robot_4", 5, Pose(3.53, 5.83, 2.3), mark="5", other_map=True),
)
HALL = hall()
SCENE = Scene("floor_0", HALL.frame, HALL, VERTICES, EDGES, ROBOTS, ("1", "2"))
FIT = Camera.fit((240, 152), WIDTH, HEIGHT)


def drawn(scene: Scene = SCENE, camera: Camera = FIT, look: MapOptions | None = None) -> Cells:
    look = look or MapOptions()
    return picture(backdrop(scene, camera, look), scene, camera, look)
