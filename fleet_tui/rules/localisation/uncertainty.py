"""How uncertain a localisation is, and whether that needs a person."""

import math

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetPose

LOST_ABOVE = 0.5
FOUND_BELOW = 0.3
"""Variance of x and y in square metres above which localisation is lost, and below which it is back."""
USUAL = 0.75
SETTLES_IN = 10.0
"""Variance that a localisation may report in so many seconds after a pose was set by hand: about the 0.5 that
come with it. One that stands then reports no other until it drives."""


def uncertainty(state: FleetState, robot: Robot, limit: float = LOST_ABOVE) -> float | None:
    """Return within how many metres a localisation believes its robot to be, None up to the limit, or if that
    is only what was set here."""
    found = robot.variance
    if found is None or found.value <= limit or (found.value <= USUAL and _was_set(state, robot, found.at)):
        return None
    return 2.0 * math.sqrt(found.value)


def _was_set(state: FleetState, robot: Robot, at: float) -> bool:
    """Tell whether this console has set the robot's pose just before."""
    set_here = (
        record.time_of(Stage.SENT)
        for record in state.commands
        if isinstance(record.command, SetPose) and record.command.robot == robot.name
    )
    return any(sent is not None and 0.0 <= at - sent <= SETTLES_IN for sent in set_here)
