"""Trips of orders that a console gave."""

from fleet_tui.model.commands import PlaceOrder
from tests.support.planted_console import PlantedConsole


def trips(it: PlantedConsole) -> list[str]:
    """The orders that were handed to the backend, by label."""
    robots = it.store.state.robots
    found = []
    for command in it.sent:
        assert isinstance(command, PlaceOrder)
        found.append(" -> ".join(robots[command.robot].name_of(stop.vertex) or "" for stop in command.stops))
    return found
