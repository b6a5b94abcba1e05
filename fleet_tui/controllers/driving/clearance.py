"""The clearance ahead of the robot that is driven, worked out ten times a second at most."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.rules.commands.set_up.checks import map_of

EVERY = 0.1
"""Seconds between two looks at the map in the same direction."""


class ClearanceAhead:
    """Keeps the newest clearance in metres."""

    def __init__(self) -> None:
        self._at = 0.0
        self._ways = (0.0, 0.0)
        self._metres = 0.0
        self._known = False

    def of(self, state: FleetState, robot: Robot, speeds: Speeds, now: float) -> float | None:
        """Return the clearance at a monotonic second, None if it does not drive ahead or has no map."""
        # With numpy, whose import takes longer than the first picture.
        from fleet_tui.rules.driving.clearance import USUAL_SIZE, clearance

        ways = speeds.ahead, speeds.sideways
        grid = map_of(state, robot, robot.floor) if robot.floor is not None else None
        if grid is None or robot.pose is None or ways == (0.0, 0.0):
            self._known = False
            return None
        if not self._known or ways != self._ways or now - self._at >= EVERY:
            found = clearance(grid, robot.pose.value, robot.size or USUAL_SIZE, speeds)
            self._known = found is not None
            self._metres = found or 0.0
            self._at = now
            self._ways = ways
        return self._metres if self._known else None
