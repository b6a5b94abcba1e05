"""The map's picture: all layers, in two parts so that robots move over a cached backdrop."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from fleet_tui.model.geometry import Line
from fleet_tui.model.set_up.streams import placed
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layers import MapOptions, draw_cursor, draw_ground, draw_labels, draw_vertices
from fleet_tui.ui.view.map.lines import (
    draw_approach,
    draw_blocked,
    draw_closed,
    draw_deadlocks,
    draw_edges,
    draw_mission,
    stroke,
)
from fleet_tui.ui.view.map.placing.labels import Backdrop, Label
from fleet_tui.ui.view.map.robots import Arrangement, draw_robots
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.map.tracing import BRAILLE, blank_mask, dots_of, ends_of, pack, set_dots, trace
from fleet_tui.ui.view.map.trails import draw_trails
from fleet_tui.ui.view.roles import WALLS, StyleRole

OUTLINE = 10.0
"""Dots of a robot's longer side from which its outline is drawn."""


Layer = Callable[[Cells, Scene, Camera, MapOptions], None]
FARTHEST = 1e9
"""Map pixels beyond which nothing is drawn."""
STILL: tuple[Layer, ...] = (draw_ground, draw_edges)
MISSION: tuple[Layer, ...] = (draw_mission, draw_vertices)
"""Below the labels. Redrawn only when the map, the graph, the mission, the camera or the options change."""


def draw_outlines(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the outline of each robot of known size, to scale, if the zoom is close enough."""
    dot = camera.scale * scene.frame.resolution
    near = [robot for robot in scene.robots if robot.size and max(robot.size) >= OUTLINE * dot]
    seen = [robot for robot in near if math.isfinite(robot.pose.x + robot.pose.y + robot.pose.yaw)]
    for role in {_outline_role(robot) for robot in seen}:
        sides = [side for robot in seen if _outline_role(robot) is role for side in _sides(robot)]
        mask = blank_mask(camera)
        trace(mask, *ends_of(scene, camera, tuple(sides)))
        stroke(cells, mask, role, look, "%")


def _outline_role(robot: SceneRobot) -> StyleRole:
    if robot.selected:
        return StyleRole.TARGET
    return StyleRole.ROBOT_BODY_ALARM if robot.alarmed else StyleRole.ROBOT_BODY


def _sides(robot: SceneRobot) -> Iterator[Line]:
    """Return the four sides of a robot's outline; its pose is in the middle."""
    assert robot.size is not None
    x, y, yaw = robot.pose.x, robot.pose.y, robot.pose.yaw
    length, width = robot.size
    ahead = math.cos(yaw) * length / 2, math.sin(yaw) * length / 2
    left = -math.sin(yaw) * width / 2, math.cos(yaw) * width / 2
    corners = [
        (x + one * ahead[0] + other * left[0], y + one * ahead[1] + other * left[1])
        for one, other in ((1, 1), (1, -1), (-1, -1), (-1, 1))
    ]
    for (from_x, from_y), (to_x, to_y) in zip(corners, [*corners[1:], corners[0]], strict=True):
        yield from_x, from_y, to_x, to_y


def draw_path(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the planned path, on free ground and over edges."""
    if scene.path is None or len(scene.path) < 2:
        return
    dots = dots_of(scene, camera, np.asarray(scene.path, np.float64))
    # One point for each cell: a path has thousands.
    moved = np.any(np.diff(np.floor(dots), axis=0) != 0, axis=1)
    dots = dots[np.concatenate(([True], moved))]
    mask = blank_mask(camera)
    trace(mask, dots[:-1], dots[1:])
    bits = pack(mask)
    free = (bits > 0) & (cells.roles <= StyleRole.MISSION_NEXT)
    free &= ~np.isin(cells.roles, WALLS)
    cells.codes[free] = ord(":") if look.plain else BRAILLE[bits[free]]
    cells.roles[free] = StyleRole.MISSION_NEXT


def draw_scan(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the ends of the laser's beams, dim if their place is not certain. On a wall of the map, where they
    are to be, its own blocks take their colour: so it still reads as a wall."""
    if scene.beams is None or scene.beams_at is None:
        return
    points = placed(scene.beams, scene.beams_at)
    mask = blank_mask(camera)
    set_dots(mask, dots_of(scene, camera, np.asarray(points, np.float64)))
    bits = pack(mask)
    drawn = (bits > 0) & (cells.roles < StyleRole.VERTEX_LABELLED)
    off_wall = drawn & ~np.isin(cells.roles, WALLS)
    cells.codes[off_wall] = ord("%") if look.plain else BRAILLE[bits[off_wall]]
    cells.roles[drawn] = StyleRole.TRAIL if scene.beams_are_old else StyleRole.SCAN


MOVING: tuple[Layer, ...] = (
    draw_trails,
    draw_path,
    draw_approach,
    draw_scan,
    draw_deadlocks,
    draw_blocked,
    draw_closed,
    draw_outlines,
)
"""Drawn at every tick; then the robots, and the layers of the mode on top."""


def backdrop(scene: Scene, camera: Camera, look: MapOptions) -> Backdrop:
    """Return the picture without the moving parts."""
    bare = Cells.blank(camera.width, camera.height, StyleRole.UNKNOWN)
    for draw in STILL:
        draw(bare, scene, camera, look)
    quiet = bare.copy()
    if not look.edges:
        draw_edges(quiet, scene, camera, replace(look, edges=True))
    for draw in MISSION:
        draw(bare, scene, camera, look)
    cells = bare.copy()
    labels = draw_labels(cells, scene, camera, look, quiet.roles)
    return Backdrop(cells.codes, cells.roles, bare, labels)


def picture(
    behind: Backdrop,
    scene: Scene,
    camera: Camera,
    look: MapOptions,
    before: Arrangement | None = None,
    top: tuple[Layer, ...] = (draw_cursor,),
) -> Cells:
    """Return the moving parts drawn over a copy of `behind` (made by `backdrop`); `before` as in
    `draw_robots`. `top`: the layers of the map's mode."""
    cells = behind.copy()
    for draw in MOVING:
        draw(cells, scene, camera, look)
    draw_robots(cells, behind, scene, camera, look, before or Arrangement())
    if _may_uncover_approach(scene, camera, behind.labels):
        draw_approach(cells, scene, camera, look)
    for draw in top:
        draw(cells, scene, camera, look)
    return cells


def _may_uncover_approach(scene: Scene, camera: Camera, labels: tuple[Label, ...]) -> bool:
    """Tell whether a label is over the edge that the selected robot drives along: there it gives way to the
    robot, after that edge was drawn around it."""
    if scene.mission is None or scene.mission.edge is None:
        return False
    x, y, to_x, to_y = scene.mission.edge
    ends = [scene.frame.to_pixel(*end) for end in ((x, y), (to_x, to_y))]
    if not all(abs(value) < FARTHEST for end in ends for value in end):  # nor for NaN
        return False
    columns, rows = zip(*(camera.to_cell(*end) for end in ends), strict=True)
    (left, right), (top, bottom) = sorted(columns), sorted(rows)
    return any(
        top <= label.at[1] <= bottom and label.at[0] <= right and left <= label.at[0] + cell_width(label.text)
        for label in labels
    )
