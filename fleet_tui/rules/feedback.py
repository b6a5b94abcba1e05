"""Feedback of a navigating robot on its active goal: it ceases only with the server that drives it."""

import math

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.robot import Robot

CEASED_AFTER = 10.0
"""Seconds without feedback, which comes many times a second while a goal is driven, until it has ceased."""


def feedback_ceased_at(state: FleetState, robot: Robot) -> float | None:
    """Return the time (monotonic) since which a robot that reports otherwise gives no feedback on its current
    order; None while it does, if it never did, and if silence has another cause."""
    order, link = robot.orders.current, state.links[robot.link]
    if math.isinf(robot.kind.silence_of("progress", 0.0)):
        return None  # sent on change only
    if order is None or robot.progress is None or robot.progress.value.goal != order.id:
        return None
    if link.phase is not Phase.UP or not state.is_online(robot) or not state.is_fresh(robot, "pose"):
        return None
    since = max(robot.progress.at, link.since)
    return since if state.now - since - state.behind >= CEASED_AFTER else None


def is_unsteady(state: FleetState, robot: Robot) -> bool:
    """Tell whether its navigation fell silent and it has not moved since: a server that is started again
    answers each new order for a moment, and crashes again."""
    began, place = state.began.get((robot.name, "navigation")), robot.place
    return began is not None and place is not None and place.at <= began and bool(robot.orders.open)
