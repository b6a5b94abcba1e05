"""World positions in the view. Invalid coordinates are outside it."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.by_identity import Same
from fleet_tui.model.geometry import MapFrame
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.glyphs import is_special
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex

Points = NDArray[np.float64]
Indices = NDArray[np.intp]
Place = tuple[int, int]
"""A cell (x, y) of the view."""


@lru_cache(maxsize=4)
def _points(vertices: Same[tuple[SceneVertex, ...]]) -> Points:
    return np.array([(vertex.x, vertex.y) for vertex in vertices.value], np.float64).reshape(-1, 2)


def seen_robots(scene: Scene, camera: Camera) -> list[tuple[SceneRobot, Place]]:
    """Return the robots in the view with their cells: the selected one, those with an alarm that waits, those
    in other trouble, in a special state, the others, each by number."""
    robots = sorted(scene.robots, key=lambda one: (not one.selected, _calm(one), one.number))
    points = np.array([(robot.pose.x, robot.pose.y) for robot in robots], np.float64).reshape(-1, 2)
    indices, places = _seen(scene.frame, camera, points)
    return [(robots[i], (x, y)) for i, (x, y) in zip(indices.tolist(), places.tolist(), strict=True)]


def _calm(robot: SceneRobot) -> int:
    if robot.alarmed:
        return 0
    if robot.obstacle or robot.acknowledged or not robot.online:
        return 1
    return 2 if is_special(robot) else 3


def seen_vertices(scene: Scene, camera: Camera) -> list[tuple[SceneVertex, Place]]:
    """Return the vertices in the view with their cells."""
    indices, places = cells_of_vertices(scene, camera)
    vertices = scene.vertices
    return [(vertices[i], (x, y)) for i, (x, y) in zip(indices.tolist(), places.tolist(), strict=True)]


def cells_of_vertices(scene: Scene, camera: Camera) -> tuple[Indices, Indices]:
    """Return the indices of the vertices in the view, and their cells (n x 2: x, y)."""
    return _seen(scene.frame, camera, _points(Same(scene.vertices)))


def _seen(frame: MapFrame, camera: Camera, points: Points) -> tuple[Indices, Indices]:
    """Return the indices of the points in the view, and their cells."""
    with np.errstate(invalid="ignore"):
        places = np.floor(pixels(frame, points) / camera.cell) - camera.origin
        inside = ((places >= 0) & (places < (camera.width, camera.height))).all(axis=1)
    return np.flatnonzero(inside), places[inside].astype(np.intp)


def pixels(frame: MapFrame, points: Points) -> Points:
    """Convert world metres (n x 2) to map pixels (column, row), as `MapFrame.to_pixel` does for one."""
    zero, right, up = (np.array(frame.to_pixel(*p)) for p in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)))
    with np.errstate(invalid="ignore", over="ignore"):
        return np.asarray(points @ np.array([right - zero, up - zero]) + zero, np.float64)
