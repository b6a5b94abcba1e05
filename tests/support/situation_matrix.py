"""Every fault of the simulated source's stack, and what each place of the console says of it:
`python -m tests.support.situation_matrix` writes docs/situations.md."""

from pathlib import Path
from typing import NamedTuple

from fleet_tui.cli.status.report import attention
from fleet_tui.cli.status.status import verdict
from fleet_tui.keys.keymap import keymap
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.lines.status import status_line
from fleet_tui.ui.view.lines.why import why_lines
from fleet_tui.ui.view.tables.doing import told_text
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import R0, text_of
from tests.support.planted_fleet import Planted
from tests.support.situations import AWAY

PAGE = Path(__file__).parents[2] / "docs" / "situations.md"
FAULTS = (
    *("obstacle", "stuck", "silent", "paused", "battery", "stale", "mislocalised", "jumping"),
    *("refuse", "restart", "foreign-cancel", "foreign-pause"),
)
EARLY, LATE = 8, 70
"""Seconds after the order: before, and after most alarms are raised."""


class Told(NamedTuple):
    """What is said of robot_0, of 2 robots. `first`: its first reason in `w`, `top`: the line above all."""

    row: str
    first: str
    title: str
    alarms: tuple[str, ...]
    top: str
    attention: tuple[str, ...]
    code: int


def told(fault: str, seconds: float) -> Told:
    """What each place says so many seconds after robot_0 got an order."""
    state = Planted(fault, quiet=True).run(1).command(AWAY).run(seconds).state
    robot = state.robots[R0]
    alarms = (one for one in state.alarms if one.holds and one.condition.source == R0)
    moving = why_lines(state, robot, keymap({})[0])[0]
    first = reasons(state, robot)[0].name
    return Told(
        told_text(state, robot),
        moving if moving.startswith(first) else first,
        text_of(fleet_table(state, R0, 118).title),
        tuple(one.text for one in alarms),
        text_of(status_line(state, R0)),
        tuple(attention(state)),
        verdict(state),
    )


def matrix() -> dict[tuple[str, int], Told]:
    return {(fault, seconds): told(fault, seconds) for fault in FAULTS for seconds in (EARLY, LATE)}


def page(found: dict[tuple[str, int], Told]) -> str:
    """The page of the documentation."""
    lines = [
        "# Situations",
        "",
        "For operators and engineers: what row, `w`, alarms, title and `status` say of each fault of a robot"
        " with an order.",
        "",
        "Two robots of the source's stack; the fault (`fleet-tui demo --fault NAME`) holds from the start,"
        f" the order to robot_0 was given {EARLY} s and {LATE} s before. Made by"
        " `python -m tests.support.situation_matrix`; a test says when it is no longer so.",
        "",
        "| fault | s | row | first line of `w` | alarms | title | exit code |",
        "|---|---|---|---|---|---|---|",
    ]
    for (fault, seconds), one in found.items():
        counts = one.title.removeprefix("Fleet ").strip()
        cells = fault, seconds, one.row, one.first, "; ".join(one.alarms) or "-", counts, one.code
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    PAGE.write_text(page(matrix()))
