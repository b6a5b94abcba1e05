"""The newest command of a kind that this console gave to a robot."""

from fleet_tui.model.commands import Command, CommandRecord, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot


def last_command(state: FleetState, robot: Robot, *kinds: type[Command]) -> CommandRecord | None:
    """Return the newest command of these kinds that this console gave to the robot."""
    ours = (one for one in reversed(state.commands) if one.command.robot == robot.name)
    return next((one for one in ours if isinstance(one.command, kinds)), None)


_UNDONE = frozenset({Stage.CHECKED, Stage.NOT_SENT, Stage.REFUSED, Stage.LOST})


def own_pause(state: FleetState, robot: Robot) -> CommandRecord | None:
    """Return the pause from here that the robot may be under: the last of its kind, unless it had no
    effect."""
    record = last_command(state, robot, PauseRobot, ResumeRobot)
    if record is None or not isinstance(record.command, PauseRobot) or record.stage in _UNDONE:
        return None
    return record


def is_paused_elsewhere(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot is under a pause that is not from here."""
    return state.is_paused(robot) and own_pause(state, robot) is None
