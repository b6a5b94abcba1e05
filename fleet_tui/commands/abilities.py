"""Commands that the robots of a kind accept."""

from typing import assert_never

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, ORDER_ANY, ORDER_TO, PAUSE, RESUME
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.text.language import EMPTY, Message


def ability_for(command: Command) -> str:
    """Return the ability that a robot needs for a command."""
    match command:
        case PlaceOrder():
            return ORDER_ANY if command.to_any else ORDER_TO if command.with_cargo else ORDER
        case CancelOrder():
            return CANCEL
        case ClearOrders():
            return CLEAR
        case PauseRobot():
            return PAUSE
        case ResumeRobot():
            return RESUME
        case SetUpCommand():
            return command.ability
        case _:
            assert_never(command)


def unaccepted(state: FleetState, command: Command) -> Message:
    """Return the reason that robots of this kind can't take a command, empty if they can."""
    robot = state.robots.get(command.robot)
    if robot is None or (ability := ability_for(command)) in robot.kind.accepts:
        return EMPTY
    return robot.kind.lack(ability)
