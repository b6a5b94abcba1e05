"""The layer of robots: each an arrow with its number beside it, as one chip."""

from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import accumulate, chain
from typing import NamedTuple

from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.glyphs import robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.places import Place, quiet_places, seen_robots
from fleet_tui.view.map.placing.crowds import crowd_chips, is_crowd
from fleet_tui.view.map.placing.labels import Backdrop, move_aside
from fleet_tui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.view.map.scene import Scene, SceneRobot
from fleet_tui.view.roles import StyleRole

NEIGHBOURS = 4
"""Cells from arrow to arrow within which robots have their numbers together, if one alone has no space."""
LARGE = 90
"""Cells of the view's width from which an alarm is told beside its robot, and the age of each offline one."""
_DOTS = "•*"
"""The place of robots with different headings; the second in ASCII."""
Chips = list[tuple[int, int, str, StyleRole]]
"""Arrows and numbers: x, y, text, role."""


class _Numbers(NamedTuple):
    """The numbers of a cell: their first cell, their side of the arrow, the texts, and the cells of all
    arrows that they are of."""

    start: int
    side: int
    runs: list[tuple[str, StyleRole]]
    arrows: tuple[Place, ...]


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
    seen = seen_robots(scene, camera)
    if is_crowd(len(seen), camera):
        chips = crowd_chips(occupancy, seen, scene.frame.origin.yaw, look.plain)
    else:
        chips = _chips(occupancy, seen, scene, camera, look, before.sides)
    move_aside(cells, behind, occupancy, before.aside)
    cells.write_all(chips)


def _chips(
    occupancy: CellOccupancy,
    seen: Sequence[tuple[SceneRobot, Place]],
    scene: Scene,
    camera: Camera,
    look: MapOptions,
    sides: dict[int, int],
) -> Chips:
    """Return the chips of all robots: the selected one on top, then those in trouble.

    The arrow is in the robot's own cell; of several robots in a cell, or side by side, the numbers are
    listed. A robot between others is listed with a neighbour, or has its number above or below, or in place
    of its arrow; without space it has none. Where numbers are listed, an arrow shows the heading of all of
    them, else there is a dot.
    """
    sharing = _groups(seen)
    plain, turned = look.plain, scene.frame.origin.yaw
    arrows = {at: _arrow(robots, at, sharing, turned, plain) for at, robots in sharing.items()}
    for (x, y), arrow in arrows.items():
        occupancy.take(x, y, len(arrow))
    quiet = quiet_places(sharing, camera)
    numbers: dict[Place, _Numbers] = {}
    for at, robots in sharing.items():
        if placed := _beside_arrow(occupancy, robots, at, len(arrows[at]), look, sides, at in quiet):
            numbers[at] = placed
    others = _between(occupancy, sharing, numbers, arrows, quiet)
    _unite(arrows, numbers.values(), plain)
    chips = [(*at, arrows[at], robot_roles(robots[0])[0]) for at, robots in sharing.items()]
    listed = (_beside(placed.start, at[1], placed.runs) for at, placed in numbers.items())
    return [*chips, *others, *chain.from_iterable(listed)]


def _between(
    occupancy: CellOccupancy,
    sharing: dict[Place, list[SceneRobot]],
    numbers: dict[Place, _Numbers],
    arrows: dict[Place, str],
    quiet: set[Place],
) -> Chips:
    """Place the numbers that have no space beside their arrow, and return the chips over cells and arrows."""
    chips: Chips = []
    for at in [at for at in sharing if at not in numbers]:
        robot = sharing[at][0]
        alone = robot_number(robot), robot_roles(robot)[1]
        if at not in quiet and (joined := _join(occupancy, numbers, at, alone)) is not None:
            chips += _bridge(occupancy, at, joined)
        elif at in quiet or not _stack(occupancy, numbers, at, alone):
            chips += _instead(occupancy, robot, at, len(arrows[at]))
    return chips


def _groups(seen: Sequence[tuple[SceneRobot, Place]]) -> dict[Place, list[SceneRobot]]:
    """Return the robots by the cell of their arrow: arrows side by side would read as one."""
    groups: dict[Place, list[SceneRobot]] = {}
    for robot, (x, y) in seen:
        near = [at for at in ((x, y), (x - 1, y), (x + 1, y)) if at in groups]
        groups.setdefault(near[0] if near else (x, y), []).append(robot)
    return groups


def _beside_arrow(
    occupancy: CellOccupancy,
    robots: list[SceneRobot],
    at: Place,
    arrow: int,
    look: MapOptions,
    sides: dict[int, int],
    is_quiet: bool,
) -> _Numbers | None:
    """Return the numbers of the robots in a cell beside their arrow of `arrow` cells, None without space.
    Those of quiet ones cover no label."""
    (x, y), first = at, robots[0]
    number = first.number
    has_alarm = occupancy.width >= LARGE and first.alarmed and first.online and first.said != ""
    has_ages = occupancy.width >= LARGE or first.selected
    for n, runs in enumerate(_numbers(robots, look.plain, has_alarm, has_ages)):
        cells = sum(len(text) for text, _ in runs)
        # The age of a pose, or an alarm, is also in a table: it covers no label.
        is_long = n == 0 and (has_alarm or not all(robot.online for robot in robots))
        before = sides.get(number, 0)
        if side := occupancy.number_side(x, y, arrow, cells, before, is_long or is_quiet):
            sides[number] = side
            # The colour of the arrow is the first one's: where that is special, its number is beside it.
            is_special = robot_roles(robots[0])[1] != StyleRole.ROBOT
            listed = runs[::-1] if side < 0 and is_special and runs[-1][0][0] != "+" else runs
            return _Numbers(x + arrow if side > 0 else x - cells, side, listed, (at,))
    return None


def _join(
    occupancy: CellOccupancy, numbers: dict[Place, _Numbers], at: Place, number: tuple[str, StyleRole]
) -> Place | None:
    """List the number of a robot between others with those of the nearest one in its row that has space, and
    return its arrow's cell, None without one: their sequence is that of the arrows."""
    x, y = at
    near = [other for other in numbers if other[1] == y and abs(other[0] - x) <= NEIGHBOURS]
    for other in sorted(near, key=lambda one: abs(one[0] - x)):
        start, side, runs, arrows = numbers[other]
        end = start + sum(len(text) for text, _ in runs)
        cells = len(number[0]) + 1
        if occupancy.extends(start - cells if side < 0 else end, y, cells, side):
            comma = ",", StyleRole.ROBOT
            listed = [*runs, comma, number] if other[0] < x else [number, comma, *runs]
            numbers[other] = _Numbers(start - cells if side < 0 else start, side, listed, (*arrows, at))
            return other
    return None


def _bridge(occupancy: CellOccupancy, at: Place, other: Place) -> Chips:
    """Fill the free cells between two arrows whose numbers are together: they are one chip."""
    between = range(min(at[0], other[0]) + 1, max(at[0], other[0]))
    free = [x for x in between if not occupancy.is_taken(x, at[1], 1)]
    for x in free:
        occupancy.take(x, at[1], 1)
    return [(x, at[1], " ", StyleRole.ROBOT) for x in free]


def _stack(
    occupancy: CellOccupancy, numbers: dict[Place, _Numbers], at: Place, number: tuple[str, StyleRole]
) -> bool:
    """Put the number of a robot above or below its arrow, if there is space."""
    x, y = at
    for row in (y - 1, y + 1):
        if (x, row) not in numbers and occupancy.extends(x, row, len(number[0]), 1):
            numbers[x, row] = _Numbers(x, 1, [number], (at,))
            return True
    return False


def _instead(occupancy: CellOccupancy, robot: SceneRobot, at: Place, arrow: int) -> Chips:
    """Put the number of a robot in place of its arrow of `arrow` cells, if there is space."""
    number = robot_number(robot)
    if len(number) < arrow or (start := occupancy.number_over(*at, len(number))) is None:
        return []
    return [(start, at[1], number, robot_roles(robot)[0])]


def _beside(x: int, y: int, runs: list[tuple[str, StyleRole]]) -> Chips:
    """Return texts one after the other from (x, y) on."""
    starts = accumulate((len(text) for text, _ in runs), initial=x)
    return [(start, y, text, role) for start, (text, role) in zip(starts, runs, strict=False)]


def _numbers(
    robots: list[SceneRobot], plain: bool, has_alarm: bool, has_ages: bool
) -> Iterator[list[tuple[str, StyleRole]]]:
    """Yield the texts beside the arrow of the robots in one cell, each with its role, the most telling first:
    all of them, the first with a count of the others, each with states and without; the first alone."""
    first, more = robots[0], len(robots) - 1
    role, count = robot_roles(first)[1], [(f"+{more}", StyleRole.ROBOT)] if more else []
    if has_alarm and first.said.isascii() and first.said.isprintable():  # each letter takes one cell
        told = f"{robot_tag(first, plain)} {first.said}", role
        numbers = [(robot_number(one), robot_roles(one)[1]) for one in robots[1:]]
        yield [told, *(run for number in numbers for run in ((",", StyleRole.ROBOT), number))]
        yield [told, *count]
    # Among several an age would read as a number of its own.
    for text in (partial(robot_tag, plain=plain, has_age=has_ages and not more), robot_number):
        tags = [(text(one), robot_roles(one)[1]) for one in robots]
        yield [run for tag in tags for run in (tag, (",", StyleRole.ROBOT))][:-1]
        if more:
            yield [tags[0], *count]
    yield [(robot_number(first), role)]


def _arrow(robots: list[SceneRobot], at: Place, taken: Container[Place], turned: float, plain: bool) -> str:
    """Return the arrow of the robots in a cell, only as wide as it hides no other one: a dot if they have
    different ones."""
    glyph, *others = {robot_glyph(robot, turned, plain) for robot in robots}
    if robots[0].selected:  # its own heading, whoever is beside it
        glyph = robot_glyph(robots[0], turned, plain)
    elif others:
        return _DOTS[plain]
    return glyph[:1] if (at[0] + 1, at[1]) in taken else glyph


def _unite(arrows: dict[Place, str], listed: Iterable[_Numbers], plain: bool) -> None:
    """Make dots of different arrows whose numbers are listed together: nobody sees whose is which."""
    for numbers in listed:
        if len({arrows[at] for at in numbers.arrows}) > 1:
            arrows.update({at: _DOTS[plain].ljust(len(arrows[at])) for at in numbers.arrows})
