"""Labels: without overlap, or not at all; they give way to robots."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.places import Place
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.roles import WALLS, StyleRole

PASSING = 3.0
"""Seconds for which a label below a robot that stays is only left out: that is calmer than one that moves."""
LEAST_START = 2
"""Letters, with the sign for the rest, up to which the start of a name is left out, too."""
VACANT = 10.0
"""Seconds without a robot after which a label goes back to its usual place."""


class Label(NamedTuple):
    """A label beside its vertex; both with their (first) cell."""

    vertex: Place
    at: Place
    text: str
    is_target: bool
    covers_walls: bool


def draw_label(cells: Cells, label: Label) -> None:
    """Draw a label in the role for the ground that it covers most of; over a wall all of it in the wall's."""
    x, y = label.at
    below = cells.roles[y, x : x + cell_width(label.text)]
    role = StyleRole.TARGET if label.is_target else StyleRole.LABEL
    if np.isin(below, WALLS).any():
        role = StyleRole.TARGET_THROUGH if label.is_target else StyleRole.LABEL_THROUGH
    elif np.count_nonzero(below == StyleRole.UNKNOWN) * 2 > below.size:
        role = StyleRole.TARGET_BEYOND if label.is_target else StyleRole.LABEL_BEYOND
    cells.write(x, y, label.text, role)


@dataclass(frozen=True, slots=True, eq=False)
class Backdrop(Cells):
    """A picture without its moving parts, and `bare` the same without its `labels`."""

    bare: Cells
    labels: tuple[Label, ...]


@dataclass
class LabelPlaces:
    """Places kept from picture to picture, by the first cells of the labels' usual places."""

    aside: dict[Place, Place] = field(default_factory=dict)
    """First cells of the labels that gave way to robots. They stay there until they are covered again, or
    their usual place has been free for a while."""
    since: dict[Place, tuple[int, float]] = field(default_factory=dict)
    """Which cells of the usual place of a label that is not there are covered, as bits, and the second since
    which they are: with robots that drive they change."""
    begun: bool = False
    """Some picture was drawn with these places."""


def move_aside(
    cells: Cells, behind: Backdrop, occupancy: CellOccupancy, places: LabelPlaces, now: float, sign: str
) -> None:
    """Leave of the labels below occupied cells the rest while robots pass; those below robots that stay move,
    in the first picture at once. `now`: its second, `sign`: the letter for what is covered."""
    for label in sorted(behind.labels, key=lambda label: not label.is_target):
        at = _place(label, behind, occupancy, places, now)
        if at != label.at:
            covered = occupancy.taken(*label.at, cell_width(label.text)) if at is None else -1
            _cover(cells, behind, label, covered, sign)
            if at is not None:
                draw_label(cells, label._replace(at=at))
    places.begun = True


def _place(
    label: Label, behind: Backdrop, occupancy: CellOccupancy, places: LabelPlaces, now: float
) -> Place | None:
    """Return and occupy a label's place now, None for none."""
    usual, size = label.at, cell_width(label.text)
    at = places.aside.get(usual, usual)
    covered = occupancy.taken(*usual, size)
    stands = not covered if at == usual else occupancy.free(*at, size)
    if stands and (at == usual or covered):
        places.since.pop(usual, None)
    else:
        before, since = places.since.get(usual, (covered, now))
        since = since if before == covered else now
        places.since[usual] = covered, since
        waited = now - since
        if not places.begun or not 0 <= waited < (VACANT if stands else PASSING):
            return _moved(label, behind, occupancy, places)
    if stands and at != usual:
        occupancy.take(*at, size)
    return at if stands else None


def _moved(label: Label, behind: Backdrop, occupancy: CellOccupancy, places: LabelPlaces) -> Place | None:
    """Return and note a label's new place: its usual one, else another at its vertex, if one is free."""
    usual = label.at
    places.since.pop(usual, None)
    places.aside.pop(usual, None)
    if not occupancy.is_taken(*usual, cell_width(label.text)):
        return usual
    # Robots come along the row of their way: above and below it is quieter; any place rather than walls.
    for in_row, covers_walls in ((False, False), (True, False), (False, label.covers_walls)):
        at = occupancy.label_spot(*label.vertex, label.text, behind.bare.roles, covers_walls, in_row)
        if at is not None:
            places.aside[usual] = at
            return at
    return None


def _cover(cells: Cells, behind: Backdrop, label: Label, covered: int, sign: str) -> None:
    """Replace a label from its first covered cell on, as bits, by what is behind it, and the letter before it
    by a sign: only a name's start reads as that name. Cells with something over them stay: a trail, an
    outline."""
    size = cell_width(label.text)
    row, columns = label.at[1], slice(label.at[0], label.at[0] + size)
    # The lowest bit that is set; half a wide letter is none.
    start = (covered & -covered).bit_length() - 1 if covered > 0 and len(label.text) == size else 0
    start = start if start > LEAST_START else 0
    rest, signs = np.arange(size) < start, np.arange(size) == start - 1
    is_label = cells.codes[row, columns] == behind.codes[row, columns]
    for plane, bare in ((cells.codes, behind.bare.codes), (cells.roles, behind.bare.roles)):
        plane[row, columns] = np.where(is_label & ~rest, bare[row, columns], plane[row, columns])
    cells.codes[row, columns][is_label & signs] = ord(sign)
