"""Warnings of the command line: of losses, and of orders that end with the command."""

from collections.abc import Iterator

from fleet_tui.model.commands import ClearOrders, PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.commands import CancelGoal, SetUpCommand
from fleet_tui.rules.commands.local_queue import clearable
from fleet_tui.rules.commands.set_up.losses import set_up_losses


def losses(state: FleetState, request: Request) -> Iterator[Problem]:
    """Return the losses that the console asks about."""
    for command in request.commands:
        robot = state.robots.get(command.robot)
        if isinstance(command, ClearOrders) and robot is not None and (count := len(clearable(state, robot))):
            text = f"{robot.name} would lose {count} order{'s' * (count != 1)}"
            yield Problem("losses", text, blocks=False)
        elif isinstance(command, CancelGoal):  # like an order's cancel, it loses nothing else
            continue
        elif isinstance(command, SetUpCommand) and robot is not None:
            lines = list(set_up_losses(state, robot, command))
            # The command is named before it, where the console asks a question.
            yield from [Problem("losses", ", ".join(lines[1:] or lines), blocks=False)] if lines else []


def unattended(state: FleetState, request: Request) -> Iterator[Problem]:
    """Return the orders whose later stops would not be sent once this command has ended."""
    for command in request.commands:
        robot = state.robots.get(command.robot)
        if isinstance(command, PlaceOrder) and robot and robot.kind.gives_stops and len(command.stops) > 1:
            text = f"{robot.name} takes one stop at a time: use --until-done to send the others"
            yield Problem("unattended", text)
