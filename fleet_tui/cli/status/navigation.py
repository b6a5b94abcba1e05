"""Values of navigating robots for `status --json`."""

from typing import Any

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, route_text
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import foreign, waiting_orders_of
from fleet_tui.situation.robots import adrift


def navigation(state: FleetState, robot: Robot) -> dict[str, Any]:
    """Return the additional values of such a robot; empty for a kind without any."""
    found: dict[str, Any] = {}
    if "progress" in robot.kind.reports:
        found["progress"] = _progress(state, robot)
    if "blocked" in robot.kind.reports:
        blocked = robot.blocked.value if robot.blocked else None
        found["blocked"] = blocked.action or None if blocked else None
        stopped = blocked is not None and blocked.is_stopped
        found["blocked_s"] = round(state.now - blocked.since, 1) if blocked and stopped else None
    if "odometry" in robot.kind.reports:
        estimate = adrift(state, robot)
        found["localisation_silent_s"] = _silence(state, robot) if estimate else None
        found["position_variance_m2"] = round(robot.variance.value, 3) if robot.variance else None
    if robot.kind.keeps_goals:
        found["kept_here"] = [_kept(robot, order) for order in waiting_orders_of(state, robot)]
        found["held"] = robot.held or None
        found["not_ours"] = [order.id for order in foreign(state, robot)]
    return found


def _silence(state: FleetState, robot: Robot) -> float | None:
    return round(state.now - robot.located_at, 1) if robot.located_at is not None else None


def _kept(robot: Robot, order: Order) -> dict[str, Any]:
    way = route_text(order.stops, lambda vertex: robot.name_of(vertex) or vertex)
    return {"id": order.id, "mission": order.label or way}


def _progress(state: FleetState, robot: Robot) -> dict[str, Any] | None:
    if robot.progress is None or robot.orders.current is None or not state.is_fresh(robot, "progress"):
        return None
    reported = robot.progress.value
    return {
        "metres": reported.metres,
        "seconds": reported.seconds,
        "elapsed_s": reported.elapsed,
        "recoveries": reported.recoveries,
        "stop": reported.stop,
    }
