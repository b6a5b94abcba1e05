"""The layer of robots: each an arrow with its number beside it, as one chip."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.glyphs import robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.view.map.labels import Backdrop, CellOccupancy, move_aside
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.places import Place, seen_robots
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.roles import StyleRole

Chips = list[tuple[int, int, str, StyleRole]]
"""Arrows and numbers: x, y, text, role."""


@dataclass
class Arrangement:
    """Places kept from picture to picture, so that nothing moves without need."""

    sides: dict[int, int] = field(default_factory=dict)
    """Side of the number of each robot by the robot's number: -1 left, 1 right of its arrow."""
    aside: dict[Place, Place] = field(default_factory=dict)
    """First cells of the labels that gave way to robots, by those of their usual places."""


def draw_robots(
    cells: Cells, behind: Backdrop, scene: Scene, camera: Camera, look: MapOptions, before: Arrangement
) -> None:
    """Draw every robot as a chip; labels of the picture `behind` give way. `before` keeps places: they stay
    while there is space."""
    occupancy = CellOccupancy(camera.width, camera.height, cells.roles)
    chips = _chips(occupancy, scene, camera, look, before.sides)
    move_aside(cells, behind, occupancy, before.aside)
    cells.write_all(chips)


def _chips(
    occupancy: CellOccupancy, scene: Scene, camera: Camera, look: MapOptions, sides: dict[int, int]
) -> Chips:
    """Return the chips of all robots: the selected one on top, then those in trouble.

    The arrow is in the robot's own cell. Where numbers would touch, one is left out; a second robot in a cell
    has its number on the other side.
    """
    placed = seen_robots(scene, camera)
    owners = {at: robot for robot, at in reversed(placed)}  # in a shared cell the first robot is visible
    plain, turned = look.plain, scene.frame.origin.yaw
    arrows = {at: _arrow(robot, at, owners, turned, plain) for at, robot in owners.items()}
    for (x, y), arrow in arrows.items():
        occupancy.take(x, y, len(arrow))
    chips: Chips = []
    for robot, (x, y) in placed:
        arrow_role, number_role = robot_roles(robot)
        arrow = arrows[x, y]
        if owners[x, y] is robot:
            chips.append((x, y, arrow, arrow_role))
        for text in dict.fromkeys((robot_tag(robot, plain), robot_number(robot))):
            side = occupancy.number_side(x, y, len(arrow), len(text), sides.get(robot.number, 0))
            if side:
                sides[robot.number] = side
                chips.append((x + len(arrow) if side > 0 else x - len(text), y, text, number_role))
                break
    return chips


def _arrow(
    robot: SceneRobot, at: Place, owners: Mapping[Place, SceneRobot], turned: float, plain: bool
) -> str:
    """Return the arrow, only as wide as it hides no other robot."""
    glyph = robot_glyph(robot, turned, plain)
    return glyph[:1] if (at[0] + 1, at[1]) in owners else glyph
