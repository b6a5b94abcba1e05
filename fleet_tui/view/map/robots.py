"""The layer of robots: each a chip of its own, its arrow before its number."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from fleet_tui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.glyphs import is_special, robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.places import Place, seen_robots
from fleet_tui.view.map.placing.crowds import COUNT, crowd_chips, is_crowd
from fleet_tui.view.map.placing.labels import Backdrop, move_aside
from fleet_tui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.roles import StyleRole

LARGE = 90
"""Cells of the view's width from which an alarm is told beside its robot, and the age of each offline one."""
FEW, DENSE = 10, 50
"""Robots of a floor up to which each has its arrow, and cells of the floor for each one below which only
those with something special have."""
TOGETHER, PILED = 3, 6
"""Robots without anything special in one cell from which such a floor has their count, and any floor."""
SHORT = 7
"""Cells of the longest chip that may cover a label."""
Runs = list[tuple[str, StyleRole]]
Chips = list[tuple[int, int, str, StyleRole]]
"""Arrows and numbers: x, y, text, role."""


@dataclass
class Arrangement:
    """Places kept from picture to picture, so that nothing moves without need."""

    shifts: dict[int, Place] = field(default_factory=dict)
    """Cells right of each robot's cell and rows below it at which its chip begins, by the robot's number."""
    aside: dict[Place, Place] = field(default_factory=dict)
    """First cells of the labels that gave way to robots, by those of their usual places."""


def draw_robots(
    cells: Cells, behind: Backdrop, scene: Scene, camera: Camera, look: MapOptions, before: Arrangement
) -> None:
    """Draw every robot as a chip; labels of the picture `behind` give way. `before` keeps places: they stay
    while there is space."""
    occupancy = CellOccupancy(camera.width, camera.height, cells.roles)
    seen = seen_robots(scene, camera)
    if is_crowd(len(seen), camera):
        chips = crowd_chips(occupancy, seen, scene.frame.origin.yaw, look.plain)
    else:
        for label in behind.labels:
            if label.is_target:
                occupancy.keep_clear(*label.vertex)
        chips = _chips(occupancy, seen, scene, look, before.shifts, is_dense(scene, camera))
    move_aside(cells, behind, occupancy, before.aside)
    cells.write_all(chips)


def is_dense(scene: Scene, camera: Camera) -> bool:
    """Tell whether the floor is so small at this zoom that arrows would take the space of numbers."""
    robots, frame = len(scene.robots), scene.frame
    cell = DOTS_X * DOTS_Y * camera.scale * camera.scale
    return robots > FEW and robots * DENSE * cell > frame.width * frame.height


def _chips(
    occupancy: CellOccupancy,
    seen: Sequence[tuple[SceneRobot, Place]],
    scene: Scene,
    look: MapOptions,
    shifts: dict[int, Place],
    dense: bool,
) -> Chips:
    """Return the chips of all robots, placed in the order of `seen`. A chip is over its robot's cell, without
    space a little off it, never beside another one: two numbers would read as one."""
    chips: Chips = []
    together = _together(seen, TOGETHER if dense else PILED)
    for robot, (x, y) in seen:
        arrow = robot_glyph(robot, scene.frame.origin.yaw, look.plain), robot_roles(robot)[0]
        texts = _texts(robot, arrow, look.plain, occupancy.width >= LARGE)
        if not is_special(robot) and (others := together.get((x, y))):
            if others[0] is not robot:
                continue
            texts = iter([[(f"{COUNT[look.plain]}{len(others)}", StyleRole.ROBOT)]])
        elif dense and not is_special(robot):
            texts = iter([[(robot_number(robot), arrow[1])]])
        chips += _placed(occupancy, robot, (x, y), texts, shifts) or _sign(occupancy, (x, y), arrow)
    return chips


def _together(seen: Sequence[tuple[SceneRobot, Place]], many: int) -> dict[Place, list[SceneRobot]]:
    """Return the robots without anything special of each cell with so many, too many for a number each."""
    groups: dict[Place, list[SceneRobot]] = {}
    for robot, at in seen:
        if not is_special(robot):
            groups.setdefault(at, []).append(robot)
    return {at: robots for at, robots in groups.items() if len(robots) >= many}


def _placed(
    occupancy: CellOccupancy, robot: SceneRobot, at: Place, texts: Iterator[Runs], shifts: dict[int, Place]
) -> Chips:
    """Return the chip with the first of the texts that has space, empty if none has."""
    for runs in texts:
        size = sum(len(text) for text, _ in runs)
        # A long text is also in a table: it covers no label.
        shift = occupancy.chip_shift(*at, size, shifts.get(robot.number), spares=size > SHORT)
        if shift is not None:
            shifts[robot.number] = shift
            return _in_row(at[0] + shift[0], at[1] + shift[1], runs)
    return []


def _sign(occupancy: CellOccupancy, at: Place, arrow: tuple[str, StyleRole]) -> Chips:
    """Return a robot's arrow alone, empty if another chip is over its cell."""
    if occupancy.is_taken(*at, 1):
        return []
    occupancy.take(*at, 1)
    return [(*at, arrow[0][:1], arrow[1])]


def _texts(robot: SceneRobot, arrow: tuple[str, StyleRole], plain: bool, is_large: bool) -> Iterator[Runs]:
    """Yield the texts of a robot's chip, each with its role, the most telling first."""
    number, role = robot_number(robot), robot_roles(robot)[1]
    is_told = is_large and robot.alarmed and robot.online and robot.said
    if is_told and robot.said.isascii() and robot.said.isprintable():  # each letter takes one cell
        yield [arrow, (f"{robot_tag(robot, plain)} {robot.said}", role)]
    if not robot.online and (is_large or robot.selected):
        yield [arrow, (robot_tag(robot, plain), role)]
    yield [arrow, (robot_tag(robot, plain, has_age=False), role)]
    yield [arrow, (number, role)]
    yield [(number, arrow[1])]


def _in_row(x: int, y: int, runs: Runs) -> Chips:
    """Return texts one after the other from (x, y) on."""
    starts = accumulate((len(text) for text, _ in runs), initial=x)
    return [(start, y, text, role) for start, (text, role) in zip(starts, runs, strict=False)]
