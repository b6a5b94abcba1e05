"""A robot's battery in its row of the fleet pane: red while it is low away from a charger."""

import math

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.why.robot import charges
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.fleet_columns import BAR
from fleet_tui.view.tables.table import Run

HALF = 50.0
"""Per cent from which a battery is not only enough, but good."""


def battery_run(state: FleetState, robot: Robot) -> Run:
    """Return the battery in per cent."""
    if robot.battery is None:
        return "  - %" if "battery" in robot.kind.reports else " " * 5, StyleRole.DIM
    percent = robot.battery.value
    if not state.is_online(robot):
        role = StyleRole.DIM
    else:
        high = StyleRole.GOOD if percent >= HALF else StyleRole.TEXT
        is_trouble = percent < state.limits.battery_low and charges(state, robot) is None
        role = StyleRole.ALARM if is_trouble else high
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", role


def battery_bar(state: FleetState, robot: Robot) -> Run:
    """Return the battery as a bar: quiet, unless it is low."""
    if robot.battery is None or not math.isfinite(robot.battery.value):
        return "", StyleRole.DIM
    cells = math.ceil(min(max(robot.battery.value, 0.0), 100.0) / 100 * BAR)
    role = battery_run(state, robot)[1]
    return "━" * cells + "┄" * (BAR - cells), role if role is StyleRole.ALARM else StyleRole.DIM
