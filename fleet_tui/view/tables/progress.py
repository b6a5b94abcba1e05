"""Progress of an order in a few words."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Robot
from fleet_tui.text.durations import age


def progress_text(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the progress of the current order: `12.5 m, 31 s, stop 1 of 2, 2 recoveries`; empty without
    fresh data."""
    if robot.progress is None or not robot.orders.is_current(order) or not state.is_fresh(robot, "progress"):
        return ""
    told = robot.progress.value
    parts = []
    if told.metres is not None:
        parts.append(f"{told.metres:.1f} m" if told.metres < 100 else f"{told.metres:.0f} m")
    if told.seconds is not None:
        parts.append(age(told.seconds))
    if told.stop is not None and len(order.stops) > 1:
        parts.append(f"stop {min(told.stop + 1, len(order.stops))} of {len(order.stops)}")
    if told.recoveries:
        parts.append(f"{told.recoveries} recover{'ies' if told.recoveries > 1 else 'y'}")
    return ", ".join(parts)
