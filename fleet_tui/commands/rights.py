"""The right that each command needs."""

from collections.abc import Iterable
from typing import assert_never

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.problem import Right
from fleet_tui.model.set_up.commands import CancelGoal, SendGoal, SetUpCommand, StartCharging

SETTING_UP = frozenset({"set-pose", "localise", "settle", "mapping", "store-map", "store-pose-graph"})
"""First words of commands that set up robots."""


def right_for(command: Command) -> Right:
    """Return the right that a command needs. A goal drives a robot as an order does."""
    match command:
        case PlaceOrder() | CancelOrder() | ClearOrders() | PauseRobot() | ResumeRobot():
            return Right.DISPATCH
        case SendGoal() | CancelGoal() | StartCharging():
            return Right.DISPATCH
        case SetUpCommand():
            return Right.SETUP
        case _:
            assert_never(command)


def right_of(verb: str) -> Right:
    """Return the right that a typed command needs, by its first word."""
    return Right.SETUP if verb in SETTING_UP else Right.DISPATCH


def needed_for(commands: Iterable[Command]) -> Right:
    """Return the right that these commands need together."""
    return max(map(right_for, commands), default=Right.VIEW)
