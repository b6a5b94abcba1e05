"""The errors that a robot reports about itself, as causes of what it does."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order_life import UNSAID, GoneOrder
from fleet_tui.model.robot import Robot

DIAGNOSED_WITHIN, LOGGED_WITHIN = 10.0, 60.0
"""Seconds for which a diagnosis, which is repeated about once a second, and a line of the log count."""
BESIDE_END = 3.0
"""Seconds before and after the end of an order within which an error of the log is about it."""


def wants_causes(state: FleetState) -> bool:
    """Tell whether the logs and diagnostics of robots may tell the cause of an alarm, or of one that is
    nearly due: they are not subscribed otherwise."""
    late = state.limits.stuck_after / 2
    return any(
        kind == "order" or (kind == "stuck" and state.now - at >= late)
        for (_, kind), at in state.began.items()
    )


def cause_of_standing(state: FleetState, robot: Robot) -> str:
    """Return the error that a robot reports about itself now, empty for none: one in its diagnostics, else
    one of its log since it stands."""
    diagnosed, logged = robot.diagnosed, robot.logged
    if diagnosed is not None and state.now - diagnosed.at < DIAGNOSED_WITHIN:
        return diagnosed.value
    since = robot.place.at - BESIDE_END if robot.place is not None else state.now
    if logged is not None and state.now - logged.at < LOGGED_WITHIN and logged.at >= since:
        return logged.value
    return ""


HELD_FAST = "Look at the robot: its wheels or its way may be blocked"
"""The remedy for a drive without progress."""
NO_WAY = "Check the goal, the map and the costmap: the robot finds no way to it"
"""The remedy for a goal without a plan."""


def remedy_of(cause: str) -> str:
    """Return the remedy for the words of a navigation stack, empty for others. Without a plan are Nav2's `no
    path to the goal` and move_base's `Failed to find a valid plan`, without progress Nav2's `Failed to make
    progress` and move_base's `Even after executing recovery behaviors`."""
    words = {*cause.replace(".", " ").split()}
    if "plan" in words or "no path" in cause:
        return NO_WAY
    return HELD_FAST if words & {"progress", "recovery"} else ""


def cause_of_end(robot: Robot, gone: GoneOrder) -> str:
    """Return why an order ended: the reason that came with its end, else the error that the log of its robot
    had just then; empty if nothing tells."""
    if gone.reason != UNSAID:
        return gone.reason
    logged = robot.logged
    return logged.value if logged is not None and abs(logged.at - gone.at) <= BESIDE_END else ""
