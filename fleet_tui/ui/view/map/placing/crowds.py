"""The chips of a crowd: neighbours as one, with their count and the worst state among them."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.glyphs import is_special, robot_glyph, robot_number, robot_roles, robot_tag
from fleet_tui.ui.view.map.places import Place
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.scene import SceneRobot
from fleet_tui.ui.view.roles import StyleRole

CROWD = 25
LEAST = 30
"""Cells of the view for each robot in it below which robots are a crowd, and robots from which they are."""
BLOCK = 6, 2
"""Cells and lines of a block of the view, whose robots are one chip: few chips are wider."""
COUNT = "×x"
"""The sign of a count; the second in ASCII."""

Seen = Sequence[tuple[SceneRobot, Place]]
Chip = tuple[int, int, str, StyleRole]


class Cluster(NamedTuple):
    """Robots near each other, with the cell of the first: it is the one that most needs a person."""

    at: Place
    robots: list[SceneRobot]


def is_crowd(robots: int, camera: Camera) -> bool:
    """Tell whether so many robots are too many in the view for a number each."""
    return robots >= LEAST and robots * CROWD > camera.width * camera.height


def clusters(seen: Seen) -> list[Cluster]:
    """Return robots, which are sorted by urgency, by block. Those in a special state are apart from all in
    other states: no state hides another."""
    found: dict[tuple[int, int, object], Cluster] = {}
    for robot, (x, y) in seen:
        state = (robot.selected, robot_roles(robot)[1]) if is_special(robot) else None
        block = x // BLOCK[0], y // BLOCK[1], state
        if block not in found:
            found[block] = Cluster((x, y), [])
        found[block].robots.append(robot)
    return list(found.values())


def crowd_chips(occupancy: CellOccupancy, seen: Seen, turned: float, plain: bool) -> list[Chip]:
    """Return a chip for each cluster: over its first robot's cell, if need be elsewhere in its block or up
    to two lines off; without space only a sign. `turned`: radians by which the map's picture is turned."""
    chips: list[Chip] = []
    for (x, y), robots in clusters(seen):
        runs = _runs(robots, turned, plain)
        cells = sum(len(text) for text, _ in runs)
        left = x // BLOCK[0] * BLOCK[0]
        starts = x, x - cells + 1, min(left, occupancy.width - cells), left + BLOCK[0] - cells
        start, line = next(_free(occupancy, starts, y, cells), (x, y))
        if not occupancy.has_room(start, line, cells):
            if occupancy.is_taken(x, y, 1):
                continue  # below a more urgent one
            runs = [(_sign(robots, turned, plain)[:1], runs[0][1])]
        for text, role in runs:
            occupancy.take(start, line, len(text))
            chips.append((start, line, text, role))
            start += len(text)
    return chips


def _free(occupancy: CellOccupancy, starts: Iterable[int], y: int, cells: int) -> Iterator[Place]:
    """Yield the places with space in line y and near it, in the nearer lines rather with a cell to the next
    chip: "0×59" would read as one."""
    near = [(start, line) for line in (y, y + 1, y - 1) for start in starts]
    yield from (at for at in near if occupancy.has_room(at[0] - 1, at[1], cells + 2))
    far = [(start, line) for line in (y + 2, y - 2) for start in starts]
    yield from (at for at in (*near, *far) if occupancy.has_room(*at, cells))


def _sign(robots: list[SceneRobot], turned: float, plain: bool) -> str:
    is_counted = len(robots) > 1 and not is_special(robots[0])
    return COUNT[plain] if is_counted else robot_glyph(robots[0], turned, plain)


def _runs(robots: list[SceneRobot], turned: float, plain: bool) -> list[tuple[str, StyleRole]]:
    first, more = robots[0], len(robots) - 1
    role, state = robot_roles(first)
    if not is_special(first):
        number = str(more + 1) if more else robot_number(first)
        return [(_sign(robots, turned, plain) + number, StyleRole.ROBOT if more else state)]
    tag = robot_tag(first, plain, has_age=False)
    count = [(f"+{more}", StyleRole.ROBOT)] if more else []
    return [(_sign(robots, turned, plain), role), (tag, state), *count]
