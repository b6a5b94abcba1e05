"""The errors that a robot reports about itself, as causes of what it does."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order_life import UNSAID, GoneOrder
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message

DIAGNOSED_WITHIN = 10.0
LOGGED_WITHIN = 60.0
"""Seconds for which a diagnosis, which is repeated about once a second, and a line of the log count."""
BESIDE_END = 3.0
"""Seconds before and after the end of an order within which a line of the log is about it first of all."""


def wants_causes(state: FleetState, selected: str = "") -> bool:
    """Tell whether the logs and diagnostics of robots may tell the cause of an alarm, of one that is nearly
    due, or of an end of the order that the selected robot, or one that this console has sent, drives: they
    are not subscribed otherwise."""
    own = {record.order_id for record in state.commands if record.order_id}
    for robot in state.robots.values():
        order = robot.orders.current if robot.kind.keeps_goals else None
        if order is not None and (robot.name == selected or order.id in own):
            return True
    late = state.limits.stuck_after / 2
    return any(
        kind == "order" or (kind == "stuck" and state.now - at >= late)
        for (_, kind), at in state.began.items()
    )


def cause_of_standing(state: FleetState, robot: Robot) -> str:
    """Return the error that a robot reports about itself now, empty for none: one in its diagnostics, else
    one of its log since it stands."""
    diagnosed = robot.diagnosed
    if diagnosed is not None and state.now - diagnosed.at < DIAGNOSED_WITHIN:
        return diagnosed.value
    since = robot.place.at - BESIDE_END if robot.place is not None else state.now
    return _told(robot, max(since, state.now - LOGGED_WITHIN), state.now, state.now)


def _told(robot: Robot, since: float, until: float, at: float) -> Message:
    """Return the line of a robot's log between two seconds that tells best why something happened `at` a
    third one, empty for none: one beside that, an error, the newest."""
    lines = [one for one in robot.logged if since <= one.at <= until]
    if not lines:
        return EMPTY
    return max(lines, key=lambda one: (one.at >= at - BESIDE_END, not one.is_warning, one.at)).text


HELD_FAST = Message("Check the robot: its wheels or its path may be blocked")
"""The remedy for a drive without progress."""
NO_WAY = Message("Check the goal, the map and the costmap: the robot finds no path")
"""The remedy for a goal without a plan."""


def remedy_of(cause: str) -> Message:
    """Return the remedy for the words of a navigation stack, empty for others. Without a plan are Nav2's `no
    path to the goal` and move_base's `Failed to find a valid plan`, without progress Nav2's `Failed to make
    progress` and move_base's `Even after executing recovery behaviors`."""
    words = {*cause.replace(".", " ").split()}
    if "plan" in words or "no path" in cause:
        return NO_WAY
    return HELD_FAST if words & {"progress", "recovery"} else EMPTY


def cause_of_end(robot: Robot, gone: GoneOrder) -> Message:
    """Return why an order ended: the reason that came with its end, else what the log of its robot told since
    it began; empty if nothing tells."""
    if gone.reason != UNSAID:
        return gone.reason
    begun = {goal.id: goal.begun_at for listed in robot.goals.values() for goal in listed if goal.begun_at}
    # One of another kind, or of long ago, has no goal.
    since = max(begun.get(gone.order.id, gone.at - BESIDE_END), gone.at - LOGGED_WITHIN)
    until = min([gone.at + BESIDE_END, *(at for at in begun.values() if at > gone.at)])
    return _told(robot, since, until, gone.at)
