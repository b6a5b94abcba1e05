"""Progress of an order in a few words."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Robot
from fleet_tui.text.durations import age
from fleet_tui.text.language import tr


def progress_text(state: FleetState, robot: Robot, order: Order) -> str:
    """Return the progress of the current order: `12.5 m left, 31 s, stop 1 of 2, 2 recoveries`, of a vehicle
    `3 nodes left`; empty without fresh data."""
    vehicle = robot.vehicle.value if robot.vehicle is not None else None
    if vehicle is not None and robot.orders.is_current(order) and state.is_fresh(robot, "vehicle"):
        left = len(vehicle.nodes_left) + vehicle.horizon
        return tr(f"{left} node{'s' * (left != 1)} left") if left else ""
    if robot.progress is None or not robot.orders.is_current(order) or not state.is_fresh(robot, "progress"):
        return ""
    reported = robot.progress.value
    parts = []
    if reported.metres is not None:
        parts.append(tr(f"{reported.metres:.{int(reported.metres < 100)}f} m left"))
    if reported.seconds is not None:
        parts.append(age(reported.seconds) if parts else tr(f"{age(reported.seconds)} left"))
    if reported.stop is not None and len(order.stops) > 1:
        parts.append(tr(f"stop {min(reported.stop + 1, len(order.stops))} of {len(order.stops)}"))
    if reported.recoveries:
        parts.append(tr(f"{reported.recoveries} recover{'ies' if reported.recoveries > 1 else 'y'}"))
    return ", ".join(parts)
