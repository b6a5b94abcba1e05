"""Simulated robots with move_base, advanced step by step: no I/O, random only by the seed."""

import random

from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.navigating.world import Clock, NavigatingWorld


class MoveBaseWorld(NavigatingWorld[SimMoveBase]):
    """`robots` robots on `floors` floors, as in NavigatingWorld."""

    def navigate(self, robot: NavigatingRobot, ids: random.Random, clock: Clock) -> SimMoveBase:
        """Make the navigation stack of a robot."""
        return SimMoveBase(robot, clock)
