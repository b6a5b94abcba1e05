"""The map's picture: all layers, in two parts so that robots move over a cached backdrop."""

from collections.abc import Callable
from dataclasses import replace

from fleet_tui.text.sanitize import cell_width
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.layers import (
    MapOptions,
    draw_cursor,
    draw_ground,
    draw_labels,
    draw_vertices,
)
from fleet_tui.view.map.lines import (
    draw_approach,
    draw_blocked,
    draw_closed,
    draw_edges,
    draw_mission,
)
from fleet_tui.view.map.outlines import draw_outlines
from fleet_tui.view.map.placing.labels import Backdrop, Label
from fleet_tui.view.map.robots import Arrangement, draw_robots
from fleet_tui.view.map.scene import Scene
from fleet_tui.view.map.streams import draw_path, draw_scan
from fleet_tui.view.map.trails import draw_trails
from fleet_tui.view.roles import StyleRole

Layer = Callable[[Cells, Scene, Camera, MapOptions], None]


FARTHEST = 1e9
"""Map pixels beyond which nothing is drawn."""

STILL: tuple[Layer, ...] = (draw_ground, draw_edges)
MISSION: tuple[Layer, ...] = (draw_mission, draw_vertices)
"""Below the labels. Redrawn only when the map, the graph, the mission, the camera or the options change."""

MOVING: tuple[Layer, ...] = (
    draw_trails,
    draw_path,
    draw_approach,
    draw_scan,
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
