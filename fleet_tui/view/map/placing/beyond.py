"""Robots off the map and out of view: each a chip at the edge of the view, with an arrow to where it is."""

import math

from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.glyphs import robot_roles, robot_tag
from fleet_tui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.view.map.scene import Scene
from fleet_tui.view.roles import StyleRole

_AWAY = tuple("⇠⇢⇡⇣"), tuple("<>^v")
"""Left, right, up, down: other arrows than those of headings; by whether only ASCII is drawn."""


def beyond(
    occupancy: CellOccupancy, scene: Scene, camera: Camera, plain: bool
) -> list[tuple[int, int, str, StyleRole]]:
    """Occupy and return the chips at the edge, as far as they have space there."""
    chips = list[tuple[int, int, str, StyleRole]]()
    for robot in scene.robots:
        pixel = scene.frame.to_pixel(robot.pose.x, robot.pose.y) if robot.misplaced else (math.nan, math.nan)
        if not all(map(math.isfinite, pixel)):
            continue
        x, y = camera.to_cell(*pixel)
        left, right, up, down = _AWAY[plain]
        aside = left if x < 0 else right if x >= camera.width else ""
        away = aside or (up if y < 0 else down if y >= camera.height else "")
        text = away + robot_tag(robot, plain, has_age=False)
        x = max(0, min(x, camera.width - len(text)))
        y = max(0, min(y, camera.height - 1))
        if away and occupancy.has_room(x, y, len(text)):
            occupancy.take(x, y, len(text))
            chips.append((x, y, text, robot_roles(robot)[1]))
    return chips
