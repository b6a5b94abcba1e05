"""Trips of orders on a console's screen."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console
from tests.support.ordering import sent


def trips(server: RosbridgeServer, it: Console) -> list[str]:
    """The orders that reached the wire, by label."""
    found = []
    for name, args in sent(server):
        assert name == "Execute_order"
        robot = it.store.state.robots["robot_0"]
        found.append(
            f"{robot.name_of(str(args['initial_point']))} -> {robot.name_of(str(args['end_point']))}"
        )
    return found
