"""The layer of robots: each an arrow with its number beside it, as one chip."""

from collections.abc import Mapping

from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.glyphs import robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.view.map.labels import CellOccupancy
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.places import Place, seen_robots
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.roles import StyleRole

Sides = dict[int, int]
"""Side of the number of each robot by the robot's number: -1 left, 1 right of its arrow."""


def draw_robots(
    cells: Cells, scene: Scene, camera: Camera, look: MapOptions, sides: Sides | None = None
) -> None:
    """Draw every robot as a chip; the selected one on top, then those in trouble.

    The arrow is in the robot's own cell. Where numbers would touch, one is left out; a second robot in a cell
    has its number on the other side. `sides` keeps the sides from picture to picture: they stay while there
    is space.
    """
    sides = {} if sides is None else sides
    placed = seen_robots(scene, camera)
    owners = {at: robot for robot, at in reversed(placed)}  # in a shared cell the first robot is visible
    plain, turned = look.plain, scene.frame.origin.yaw
    arrows = {at: _arrow(robot, at, owners, turned, plain) for at, robot in owners.items()}
    occupancy = CellOccupancy(camera.width, camera.height, cells.roles)
    for (x, y), arrow in arrows.items():
        occupancy.take(x, y, len(arrow))
    texts: list[tuple[int, int, str, StyleRole]] = []
    for robot, (x, y) in placed:
        arrow_role, number_role = robot_roles(robot)
        arrow = arrows[x, y]
        if owners[x, y] is robot:
            texts.append((x, y, arrow, arrow_role))
        for text in dict.fromkeys((robot_tag(robot, plain), robot_number(robot))):
            side = occupancy.number_side(x, y, len(arrow), len(text), sides.get(robot.number, 0))
            if side:
                sides[robot.number] = side
                texts.append((x + len(arrow) if side > 0 else x - len(text), y, text, number_role))
                break
    cells.write_all(texts)


def _arrow(
    robot: SceneRobot, at: Place, owners: Mapping[Place, SceneRobot], turned: float, plain: bool
) -> str:
    """Return the arrow, only as wide as it hides no other robot."""
    glyph = robot_glyph(robot, turned, plain)
    return glyph[:1] if (at[0] + 1, at[1]) in owners else glyph
