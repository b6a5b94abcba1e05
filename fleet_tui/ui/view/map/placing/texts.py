"""The texts of a robot's chip."""

import re
from collections.abc import Iterator
from functools import lru_cache

from fleet_tui.ui.view.map.glyphs import robot_number, robot_roles, robot_tag
from fleet_tui.ui.view.map.placing.chips import ChipSize
from fleet_tui.ui.view.map.scene import SceneRobot
from fleet_tui.ui.view.roles import StyleRole

SAID = 24
"""Cells of an alarm's text beside its robot: the alarms pane has longer ones."""
Runs = list[tuple[str, StyleRole]]
Text = tuple[ChipSize, Runs]


def texts_of(robot: SceneRobot, arrow: tuple[str, StyleRole], plain: bool, is_large: bool) -> Iterator[Text]:
    """Yield the texts of a robot's chip, each with its role, the most telling first."""
    tag, role = robot_tag(robot, plain, has_age=False), robot_roles(robot)[1]
    is_told = is_large and robot.alarmed and robot.online and robot.said
    said = _short(robot.said) if is_told else ""
    if said.isascii() and said.isprintable() and said:  # each letter takes one cell
        yield text_of(arrow, (tag, role), right=(f" {said}", role))
        yield text_of(arrow, (tag, role), left=(f"{said} ", role))
    if not robot.online and (is_large or robot.selected):
        number, age = robot_tag(robot, plain).split(" ", 1)
        yield text_of(arrow, (number, role), right=(f" {age}", role))
    cells = len(arrow[0]) + len(tag)
    yield ChipSize(cells, cells), [arrow, (tag, role)]  # of most robots: without the sums of `_text`
    yield text_of(arrow, (robot_number(robot), role))
    yield text_of((robot_number(robot), arrow[1]))


@lru_cache(maxsize=256)
def _short(said: str) -> str:
    """Return an alarm's text up to a comma, a colon or a bracket, empty if even that is long."""
    head = said if len(said) <= SAID else re.split(r", | \(|: ", said)[0]
    return head if len(head) <= SAID else ""


def text_of(
    *head: tuple[str, StyleRole],
    left: tuple[str, StyleRole] | None = None,
    right: tuple[str, StyleRole] | None = None,
) -> Text:
    """Return the runs of a chip with their size: those that stand at the robot, and a text beside them."""
    runs = [run for run in (left, *head, right) if run is not None]
    cells, of_head = (sum(len(text) for text, _ in part) for part in (runs, head))
    return ChipSize(cells, of_head, left is not None), runs
