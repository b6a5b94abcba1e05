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
from fleet_tui.view.map.placing.labels import Backdrop, LabelPlaces, move_aside
from fleet_tui.view.map.placing.occupancy import CellOccupancy, ChipSize
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.roles import StyleRole

LARGE = 90
"""Cells of the view's width from which an alarm is told beside its robot, and the age of each offline one."""
FEW, DENSE = 10, 50
"""Robots of a floor up to which each has its arrow, and cells of the floor for each one below which only
those with something special have."""
TOGETHER, PILED = 3, 6
"""Robots without anything special in one cell from which such a floor has their count, and any floor."""
SAID = 24, 12
"""Cells to which an alarm's text is cut where there is no space for all of it."""
Runs = list[tuple[str, StyleRole]]
Text = tuple[ChipSize, Runs]
Chips = list[tuple[int, int, str, StyleRole]]
"""Arrows and numbers: x, y, text, role."""


@dataclass
class Arrangement:
    """Places kept from picture to picture, so that nothing moves without need."""

    shifts: dict[int, Place] = field(default_factory=dict)
    """Cells right of each robot's cell and rows below it at which its chip begins, by the robot's number."""
    labels: LabelPlaces = field(default_factory=LabelPlaces)


def draw_robots(
    cells: Cells, behind: Backdrop, scene: Scene, camera: Camera, look: MapOptions, before: Arrangement
) -> None:
    """Draw every robot as a chip over the labels of the picture `behind`. `before` keeps places: they stay
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
    move_aside(cells, behind, occupancy, before.labels, scene.at)
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
    for robot, at in seen:
        arrow_role, role = robot_roles(robot)
        arrow = robot_glyph(robot, scene.frame.origin.yaw, look.plain), arrow_role
        only: tuple[str, StyleRole] | None = None
        if not is_special(robot) and (others := together.get(at)):
            if others[0] is not robot:
                continue
            only = f"{COUNT[look.plain]}{len(others)}", StyleRole.ROBOT
        elif dense and not is_special(robot):
            only = robot_number(robot), arrow_role
        is_large = occupancy.width >= LARGE
        texts = iter([_text(only)]) if only else _texts(robot, arrow, look.plain, is_large)
        chip = _placed(occupancy, robot, at, texts, shifts) or _sign(occupancy, at, arrow)
        if not chip:
            least = _text(only or (robot_tag(robot, look.plain, has_age=False), role))
            chip = _placed(occupancy, robot, at, iter([least]), shifts, far=True)
        chips += chip
    return chips


def _together(seen: Sequence[tuple[SceneRobot, Place]], many: int) -> dict[Place, list[SceneRobot]]:
    """Return the robots without anything special of each cell with so many, too many for a number each."""
    groups: dict[Place, list[SceneRobot]] = {}
    for robot, at in seen:
        if not is_special(robot):
            groups.setdefault(at, []).append(robot)
    return {at: robots for at, robots in groups.items() if len(robots) >= many}


def _placed(
    occupancy: CellOccupancy,
    robot: SceneRobot,
    at: Place,
    texts: Iterator[Text],
    shifts: dict[int, Place],
    far: bool = False,
) -> Chips:
    """Return the chip with the first of the texts that has space, empty if none has; `far`: away from its
    robot, which nothing else would show."""
    for size, runs in texts:
        shift = occupancy.chip_shift(*at, size, shifts.get(robot.number), far)
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


def _texts(robot: SceneRobot, arrow: tuple[str, StyleRole], plain: bool, is_large: bool) -> Iterator[Text]:
    """Yield the texts of a robot's chip, each with its role, the most telling first."""
    tag, role = robot_tag(robot, plain, has_age=False), robot_roles(robot)[1]
    is_told = is_large and robot.alarmed and robot.online and robot.said
    if is_told and robot.said.isascii() and robot.said.isprintable():  # each letter takes one cell
        for said in _cuts(robot.said, plain):
            yield _text(arrow, (tag, role), right=(f" {said}", role))
            yield _text(arrow, (tag, role), left=(f"{said} ", role))
    if not robot.online and (is_large or robot.selected):
        number, age = robot_tag(robot, plain).split(" ", 1)
        yield _text(arrow, (number, role), right=(f" {age}", role))
    cells = len(arrow[0]) + len(tag)
    yield ChipSize(cells, cells), [arrow, (tag, role)]  # of most robots: without the sums of `_text`
    yield _text(arrow, (robot_number(robot), role))
    yield _text((robot_number(robot), arrow[1]))


def _cuts(said: str, plain: bool) -> Iterator[str]:
    """Yield an alarm's text, and its beginning in ever fewer cells."""
    yield said
    end = "." if plain else "…"
    yield from (said[: cells - 1].rstrip() + end for cells in SAID if len(said) > cells)


def _text(
    *head: tuple[str, StyleRole],
    left: tuple[str, StyleRole] | None = None,
    right: tuple[str, StyleRole] | None = None,
) -> Text:
    """Return the runs of a chip with their size: those that stand at the robot, and a text beside them."""
    runs = [run for run in (left, *head, right) if run is not None]
    cells, of_head = (sum(len(text) for text, _ in part) for part in (runs, head))
    return ChipSize(cells, of_head, left is not None), runs


def _in_row(x: int, y: int, runs: Runs) -> Chips:
    """Return texts one after the other from (x, y) on."""
    starts = accumulate((len(text) for text, _ in runs), initial=x)
    return [(start, y, text, role) for start, (text, role) in zip(starts, runs, strict=False)]
