"""The way of a robot to a charger, and the order that leads there."""

import math

from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph, Vertex
from fleet_tui.model.kind import ORDER_TO
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.situation.battery.charging import charger_of, charging_reported
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message


def way_to_charger(state: FleetState, robot: Robot) -> tuple[Place, ...]:
    """Return the vertex nearest to a robot and the nearest free charger on its floor that it can reach from
    there; empty without one, or if it is there."""
    try:
        return _way(state, robot)
    except CommandError:
        return ()


def order_to_charger(state: FleetState, robot: Robot) -> Request:
    """Return the order to the nearest free charger, and the start of its charge where that is no part of the
    order. A robot that brings cargo has orders from somewhere. Raises CommandError if there is no way to
    one."""
    charge = _charge(robot)
    if charge and charger_of(state, robot) is not None and charging_reported(state, robot) is None:
        return Request(charge)
    way: tuple[Place, ...] = _way(state, robot)
    if ORDER_TO in robot.kind.accepts and not robot.kind.brings_cargo:
        way = way[-1:]
    stops = at_vertices(*(place.vertex for place in way))
    floors = tuple((one.vertex, one.floor) for one in way)
    return Request((PlaceOrder(robot.name, stops), *charge), floors, doubt=_doubt(robot))


def _charge(robot: Robot) -> tuple[StartCharging, ...]:
    """Return the command that makes a vehicle charge once it is there, if its order can't."""
    is_beside = robot.features is not None and robot.features.charges_beside
    return (StartCharging(robot.name),) if is_beside else ()


def _doubt(robot: Robot) -> Message:
    """Return that a vehicle is not told to charge once it is there, empty if it is, or others do it."""
    if robot.vehicle is None:
        return EMPTY
    if robot.features is None:
        return Message(
            "{name} only drives there: without a factsheet nothing starts its charge", name=robot.name
        )
    if robot.features.charges or robot.features.charges_beside:
        return EMPTY
    return Message("{name} only drives there: its factsheet has no startCharging", name=robot.name)


def _way(state: FleetState, robot: Robot) -> tuple[Place, Place]:
    """Return where the way to a charger begins and ends. Raises CommandError if there is none."""
    if robot.pose is None or robot.floor is None:
        raise CommandError(Message("the place of {name} is not known", name=robot.name))
    here, pose = robot.maps.get(robot.floor, RobotMap()), robot.pose.value
    if here.graph is None or not here.graph.chargers:
        raise CommandError(Message("no graph shows a charger on {floor}", floor=robot.floor))

    others = [one for one in state.robots.values() if one.name != robot.name and one.floor == robot.floor]
    taken = {charger.id for one in others if (charger := charger_of(state, one)) is not None}
    free = [one for one in here.graph.chargers if one.id not in taken]
    if not free:
        raise CommandError(Message("other robots are at all chargers of {floor}", floor=robot.floor))

    def metres(vertex: Vertex) -> float:
        return math.dist((vertex.x, vertex.y), (pose.x, pose.y))

    start = min(here.graph.vertices.values(), key=metres)
    ways = {one.id: _metres(here.graph, start, one, metres(one)) for one in free}
    nearest = min(ways, key=lambda id_: ways[id_])
    if nearest == start.id:
        raise CommandError(Message("{name} is at a charger", name=robot.name))
    if not math.isfinite(ways[nearest]):
        raise CommandError(Message("no path on the graph leads {name} to a charger", name=robot.name))
    begin, end = (Place(id_, here.name_of(id_) or id_, robot.floor) for id_ in (start.id, nearest))
    return begin, end


def _metres(graph: RouteGraph, start: Vertex, charger: Vertex, straight: float) -> float:
    """Return the metres of the way to a charger, infinite without one; without edges those to it."""
    return graph.metres_to([charger.id]).get(start.id, math.inf) if graph.edges else straight
