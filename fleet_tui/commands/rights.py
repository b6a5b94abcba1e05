"""The right that each command needs."""

from collections.abc import Iterable
from typing import assert_never

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.problem import Permissions, Problem, Right
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


def not_allowed(commands: Iterable[Command], allowed: Permissions) -> list[Problem]:
    """Check that the user may give these commands, a pause among them."""
    needed = max(map(right_for, commands), default=Right.VIEW)
    refusal = allowed.refusal(needed)
    return [Problem("not allowed", refusal)] if refusal else []
