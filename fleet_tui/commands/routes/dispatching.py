"""Orders that a dispatcher gives to any of its robots."""

from collections.abc import Sequence

from fleet_tui.commands.language.any_robot import own_place
from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER_ANY
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request


def to_any(state: FleetState, places: Sequence[Place]) -> Request | None:
    """Return the order to any robot of a dispatcher that knows the places, None without one. It leaves by the
    link of a robot that is online, if there is one."""
    robots = [robot for robot in state.robots.values() if ORDER_ANY in robot.kind.accepts]
    for robot in sorted(robots, key=lambda one: not state.is_online(one)):
        own = [place for one in places if (place := own_place(state, robot, one)) is not None]
        if own and len(own) == len(places):
            vertices = [place.vertex for place in own]
            floors = tuple((place.vertex, place.floor) for place in own)
            return Request((PlaceOrder(robot.name, at_vertices(*vertices), to_any=True),), floors)
    return None
