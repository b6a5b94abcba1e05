"""A robot's battery in its row of the fleet pane: amber while it is low, red while critical, at a charger,
too."""

import math

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.fleet_columns import BAR
from fleet_tui.view.tables.table import Run


def battery_run(state: FleetState, robot: Robot) -> Run:
    """Return the battery in per cent."""
    if robot.battery is None:
        return "  - %" if "battery" in robot.kind.reports else " " * 5, StyleRole.DIM
    percent, limits = robot.battery.value, state.limits
    if not state.is_online(robot):
        role = StyleRole.DIM
    elif percent < limits.battery_critical:
        role = StyleRole.ALARM
    else:
        role = StyleRole.WARN if percent < limits.battery_low else StyleRole.TEXT
    # Rounded down: 19.6 is below 20, and must not read 20 in red.
    return f"{int(percent):3d} %", role


def battery_bar(state: FleetState, robot: Robot) -> Run:
    """Return the battery as a bar: quiet, unless it is low."""
    if robot.battery is None or not math.isfinite(robot.battery.value):
        return "", StyleRole.DIM
    cells = math.ceil(min(max(robot.battery.value, 0.0), 100.0) / 100 * BAR)
    role = battery_run(state, robot)[1]
    is_low = role in (StyleRole.ALARM, StyleRole.WARN)
    return "━" * cells + "┄" * (BAR - cells), role if is_low else StyleRole.DIM
