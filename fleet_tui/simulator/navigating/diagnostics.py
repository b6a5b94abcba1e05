"""Texts about robots that navigate: entries of /diagnostics, log lines about obstacles."""

from collections.abc import Iterator
from typing import Any

from fleet_tui.simulator.logs import BROKEN, DOUBTFUL, HEALTHY, entry
from fleet_tui.simulator.navigating.robot import LOST, NavigatingRobot
from fleet_tui.simulator.robot import EMPTY, LOW

Message = dict[str, Any]


def health(robot: NavigatingRobot) -> Iterator[Message]:
    """The entries of /diagnostics about one robot."""
    empty, low = robot.battery < EMPTY, robot.battery < LOW
    level = BROKEN if empty else DOUBTFUL if low else HEALTHY
    message = "empty" if empty else "low" if low else "charging" if robot.docked else "charged"
    yield entry(robot, "battery", level, message, percent=f"{robot.battery:.1f}")
    lost = robot.variance >= LOST
    yield entry(
        robot,
        "localisation",
        DOUBTFUL if lost else HEALTHY,
        "not sure where it is" if lost else "localised",
        variance=f"{robot.variance:g}",
    )
