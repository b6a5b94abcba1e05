"""Alarm rules for navigating robots: blocked, lost on its map, orders held for the operator."""

from fleet_tui.model.alarm import Condition, Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import blocked_text
from fleet_tui.model.robot import Robot
from fleet_tui.rules.alarms.floods import ActiveConditions
from fleet_tui.rules.commands.local_queue import HELD_BY_OTHERS, orders_to_save

LOST_ABOVE, FOUND_BELOW = 0.5, 0.3
"""Variance of x and y in square metres above which localisation is lost, and below which it is back."""


def blocked(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise after a stop by its collision monitor for longer than the limit, by its last report."""
    if robot.blocked is None or not robot.blocked.value.is_stopped:
        return None
    held_back = robot.blocked.value
    due = held_back.since + state.limits.obstacle_after
    text = blocked_text(held_back, state.now)
    return Condition(robot.name, "blocked", Priority.HIGH, text, "cleared: obstacle", due)


def not_sure_where(state: FleetState, robot: Robot, active: ActiveConditions) -> Condition | None:
    """Raise if its localisation is too uncertain to drive by."""
    if robot.variance is None:
        return None
    limit = FOUND_BELOW if (robot.name, "localisation") in active else LOST_ABOVE
    if robot.variance.value <= limit:
        return None
    text = f"localisation uncertain: within {2 * robot.variance.value**0.5:.1f} m"
    return Condition(robot.name, "localisation", Priority.MEDIUM, text, "localisation recovered")


def held_orders(state: FleetState, robot: Robot, _active: ActiveConditions) -> Condition | None:
    """Raise for orders held here until the operator releases them."""
    if not robot.held:
        return None
    kept = sum(1 for _ in orders_to_save(state, robot))
    if not kept:
        return None
    text = f"{robot.held}: {kept} order{'s' * (kept > 1)} waiting here, resume to continue"
    priority = Priority.MEDIUM if robot.held in HELD_BY_OTHERS else Priority.LOW
    return Condition(robot.name, "held", priority, text, "orders resumed")


NAVIGATION_RULES = (blocked, not_sure_where, held_orders)
