"""Labels: whole and without overlap, or not at all; they give way to robots."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from fleet_tui.text.sanitize import cell_width
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.places import Place
from fleet_tui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.view.roles import StyleRole


class Label(NamedTuple):
    """A label beside its vertex; both with their (first) cell."""

    vertex: Place
    at: Place
    text: str
    is_target: bool
    covers_walls: bool


def draw_label(cells: Cells, label: Label) -> None:
    """Draw a label in the role for the ground that it covers most of."""
    x, y = label.at
    below = cells.roles[y, x : x + cell_width(label.text)]
    role = StyleRole.TARGET if label.is_target else StyleRole.LABEL
    if np.count_nonzero(below == StyleRole.UNKNOWN) * 2 > below.size:
        role = StyleRole.TARGET_BEYOND if label.is_target else StyleRole.LABEL_BEYOND
    cells.write(x, y, label.text, role)


@dataclass(frozen=True, slots=True, eq=False)
class Backdrop(Cells):
    """A picture without its moving parts, and `bare` the same without its `labels`."""

    bare: Cells
    labels: tuple[Label, ...]


def move_aside(cells: Cells, behind: Backdrop, occupancy: CellOccupancy, aside: dict[Place, Place]) -> None:
    """Move labels from below occupied cells, or leave them out: half a name reads as another one.

    `aside`: the first cells of the labels that gave way, now by before. They stay there until they would be
    covered again.
    """
    for label in sorted(behind.labels, key=lambda label: not label.is_target):
        size = cell_width(label.text)
        moved = aside.pop(label.at, None)
        if moved is None and not occupancy.is_taken(*label.at, size):
            continue
        _erase(cells, behind, label.at, size)
        if moved is not None and occupancy.free(*moved, size):
            occupancy.take(*moved, size)
        elif moved is not None and not occupancy.is_taken(*label.at, size):
            moved = label.at
        else:
            # Robots come along the row of their way: above and below it is quieter.
            moved = occupancy.label_spot(
                *label.vertex, label.text, behind.bare.roles, label.covers_walls, in_row=False
            )
        if moved is None:
            continue
        draw_label(cells, label._replace(at=moved))
        if moved != label.at:
            aside[label.at] = moved


def _erase(cells: Cells, behind: Backdrop, at: Place, size: int) -> None:
    """Replace a label by what is behind it, but for cells with something over it: a trail, an outline."""
    row, columns = at[1], slice(at[0], at[0] + size)
    is_label = cells.codes[row, columns] == behind.codes[row, columns]
    for plane, bare in ((cells.codes, behind.bare.codes), (cells.roles, behind.bare.roles)):
        plane[row, columns] = np.where(is_label, bare[row, columns], plane[row, columns])
