"""The check whether another console of the desk has claimed a robot."""

from collections.abc import Iterator

from fleet_tui.model.commands import Command
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot


def claimed(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that no other console of the desk has claimed the robot."""
    if names := state.desk.other_holders(robot.name):
        yield Problem("claimed", f"{robot.name} is claimed by {' and '.join(names)}", blocks=False)
