"""The layer of outlines: robots of known size, to scale."""

import math
from collections.abc import Iterator

from fleet_tui.model.geometry import Line
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.lines import stroke
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.map.tracing import blank_mask, ends_of, trace
from fleet_tui.view.roles import StyleRole

OUTLINE = 10.0
"""Dots of a robot's longer side from which its outline is drawn."""


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
