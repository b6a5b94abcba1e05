"""The layer of robots: each a chip of its own, its arrow before its number."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate
from typing import NamedTuple

from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.glyphs import is_special, robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.places import Place, seen_robots
from fleet_tui.ui.view.map.placing.chips import ChipSize
from fleet_tui.ui.view.map.placing.crowds import COUNT, crowd_chips, is_crowd
from fleet_tui.ui.view.map.placing.labels import Backdrop, LabelPlaces, move_aside
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.placing.texts import Runs, Text, text_of, texts_of
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.roles import StyleRole

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


LARGE = 90
"""Cells of the view's width from which an alarm is told beside its robot, and the age of each offline one."""
FEW = 10
DENSE = 50
"""Robots of a floor up to which all have space for an arrow, and cells of the floor for each one below which
numbers are placed first."""
TOGETHER = 3
PILED = 6
"""Robots without anything special in one cell from which they have a count if not all numbers find a place
near them, and from which they always have."""
Chips = list[tuple[int, int, str, StyleRole]]
"""Arrows and numbers: x, y, text, role."""


class Number(NamedTuple):
    """A number without its arrow, and its first cell as seen from its robot's."""

    text: str
    shift: Place


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
    astray = beyond(occupancy, scene, camera, look.plain)
    seen = seen_robots(scene, camera)
    if is_crowd(len(seen), camera):
        chips = crowd_chips(occupancy, seen, scene.frame.origin.yaw, look.plain)
    else:
        stood_on = {at for _, at in seen}
        for label in behind.labels:
            if label.is_target and label.vertex not in stood_on:
                occupancy.keep_clear(*label.vertex)
        chips = _chips(occupancy, seen, scene, look, before.shifts, is_dense(scene, camera))
    move_aside(cells, behind, occupancy, before.labels, scene.at, "~" if look.plain else "…")
    cells.write_all(astray + chips)


def is_dense(scene: Scene, camera: Camera) -> bool:
    """Tell whether the floor is so small at this zoom that arrows may take the space of numbers."""
    robots, frame = len(scene.robots), scene.frame
    return robots > FEW and robots * DENSE * math.prod(camera.cell) > frame.width * frame.height


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
    numbers: list[tuple[SceneRobot, Place, Number]] = []
    together = _together(seen, TOGETHER if dense else PILED)
    for robot, at in seen:
        arrow = robot_glyph(robot, scene.frame.origin.yaw, look.plain), robot_roles(robot)[0]
        if not is_special(robot) and (others := together.get(at)):
            if others[0] is robot:
                apart = _numbers(occupancy, others, at, shifts)
                numbers += apart
                chips += [] if apart else _pile(occupancy, others, at, look.plain, shifts)
        elif dense and not is_special(robot) and (apart := _numbers(occupancy, [robot], at, shifts)):
            numbers += apart
        else:
            texts = texts_of(robot, arrow, look.plain, occupancy.width >= LARGE)
            chips += _whole_or_least(occupancy, robot, at, texts, arrow, look.plain, shifts)
    for robot, at, number in numbers:
        arrow = robot_glyph(robot, scene.frame.origin.yaw, look.plain), robot_roles(robot)[0]
        chips += _with_arrow(occupancy, robot, at, number, arrow)
    return chips


def _whole_or_least(
    occupancy: CellOccupancy,
    robot: SceneRobot,
    at: Place,
    texts: Iterator[Text],
    arrow: tuple[str, StyleRole],
    plain: bool,
    shifts: dict[int, Place],
) -> Chips:
    """Return the chip with the first text that has space, else the arrow alone, else a chip two rows off."""
    if robot.misplaced:
        chip = _in_place(occupancy, at, texts)  # a cell off it would be inside the building
    else:
        chip = _placed(occupancy, robot, at, texts, shifts)
    if chip := chip or _sign(occupancy, at, arrow):
        return chip
    least = text_of((robot_tag(robot, plain, has_age=False), robot_roles(robot)[1]))
    return _placed(occupancy, robot, at, iter([least]), shifts, far=True)


def _in_place(occupancy: CellOccupancy, at: Place, texts: Iterator[Text]) -> Chips:
    """Return the chip that covers its robot's cell with the first of the texts that has space."""
    x, y = at
    for size, runs in texts:
        start = min(x, occupancy.width - size.cells)
        if (start == x or not size.has_text) and occupancy.has_room(start, y, size.cells):
            occupancy.take(start, y, size.cells)
            return _in_row(start, y, runs)
    return []


def _numbers(
    occupancy: CellOccupancy, robots: Sequence[SceneRobot], at: Place, shifts: dict[int, Place]
) -> list[tuple[SceneRobot, Place, Number]]:
    """Occupy places for the numbers alone of robots in one cell; none if not all have one, or they are too
    many. `shifts` keeps those of the last picture."""
    if len(robots) >= PILED:
        return []
    placed: list[tuple[SceneRobot, Place, Number]] = []
    for robot in robots:
        text = robot_number(robot)
        shift = occupancy.chip_shift(*at, ChipSize(len(text), len(text)), shifts.get(robot.number))
        if shift is None:
            for _, _, (other, (x, y)) in placed:
                occupancy.release(at[0] + x, at[1] + y, len(other))
            return []
        placed.append((robot, at, Number(text, shift)))
    shifts |= {robot.number: number.shift for robot, _, number in placed}
    return placed


def _with_arrow(
    occupancy: CellOccupancy, robot: SceneRobot, at: Place, number: Number, arrow: tuple[str, StyleRole]
) -> Chips:
    """Return a number at its place, after its arrow if there is space for that."""
    (text, (right, down)), (glyph, role) = number, arrow
    x, y = at[0] + right, at[1] + down
    first = occupancy.widen(x, y, len(text), len(glyph))
    if first is None:
        return [(x, y, text, role)]
    return [(first, y, glyph, role), (first + len(glyph), y, text, robot_roles(robot)[1])]


def _pile(
    occupancy: CellOccupancy, robots: Sequence[SceneRobot], at: Place, plain: bool, shifts: dict[int, Place]
) -> Chips:
    """Return the count of robots in one cell."""
    count = text_of((f"{COUNT[plain]}{len(robots)}", StyleRole.ROBOT))
    near_or_far = (_placed(occupancy, robots[0], at, iter([count]), shifts, far) for far in (False, True))
    return next(filter(None, near_or_far), [])


def _together(seen: Sequence[tuple[SceneRobot, Place]], many: int) -> dict[Place, list[SceneRobot]]:
    """Return the robots without anything special of each cell with so many."""
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


def _in_row(x: int, y: int, runs: Runs) -> Chips:
    """Return texts one after the other from (x, y) on."""
    starts = accumulate((len(text) for text, _ in runs), initial=x)
    return [(start, y, text, role) for start, (text, role) in zip(starts, runs, strict=False)]
