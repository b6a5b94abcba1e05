"""World positions in the view. Invalid coordinates are outside it."""

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import MapFrame
from fleet_tui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex

Points = NDArray[np.float64]
Place = tuple[int, int]
"""A cell (x, y) of the view."""


def seen_robots(scene: Scene, camera: Camera) -> list[tuple[SceneRobot, Place]]:
    """Return the robots in the view with their cells: the selected one, those in trouble, the others, each by
    number."""
    robots = sorted(
        scene.robots,
        key=lambda one: (not one.selected, one.online and not (one.obstacle or one.alarmed), one.number),
    )
    points = [(robot.pose.x, robot.pose.y) for robot in robots]
    return [(robots[i], place) for i, place in _seen(scene.frame, camera, points)]


def seen_vertices(scene: Scene, camera: Camera) -> list[tuple[SceneVertex, Place]]:
    """Return the vertices in the view with their cells."""
    points = [(vertex.x, vertex.y) for vertex in scene.vertices]
    return [(scene.vertices[i], place) for i, place in _seen(scene.frame, camera, points)]


def _seen(frame: MapFrame, camera: Camera, points: list[tuple[float, float]]) -> list[tuple[int, Place]]:
    """Return the index and the cell of each point in the view."""
    if not points:
        return []
    with np.errstate(invalid="ignore"):
        cell = (DOTS_X * camera.scale, DOTS_Y * camera.scale)
        places = np.floor(pixels(frame, np.array(points)) / cell) - camera.origin
        inside = ((places >= 0) & (places < (camera.width, camera.height))).all(axis=1)
    cells = places[inside].astype(np.intp).tolist()
    return [(i, (x, y)) for i, (x, y) in zip(np.flatnonzero(inside).tolist(), cells, strict=True)]


def pixels(frame: MapFrame, points: Points) -> Points:
    """Convert world metres (n x 2) to map pixels (column, row), as `MapFrame.to_pixel` does for one."""
    zero, right, up = (np.array(frame.to_pixel(*p)) for p in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)))
    with np.errstate(invalid="ignore", over="ignore"):
        return np.asarray(points @ np.array([right - zero, up - zero]) + zero, np.float64)
