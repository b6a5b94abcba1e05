"""The way of a robot to a charger, and the order that leads there."""

import math

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.nearest import GraphDistances, metres_to
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Vertex
from fleet_tui.model.kind import ORDER_TO
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.set_up.commands import StartCharging
from fleet_tui.situation.battery.charging import AT_CHARGER, charger_of, charging_reported
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message


def way_to_charger(state: FleetState, robot: Robot) -> tuple[Place, ...]:
    """Return the vertex nearest to a robot and the nearest free charger that it can reach from there, by lift
    if its orders change floors; empty without one, or if it is there."""
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
    floor, pose = robot.floor, robot.pose.value
    floors = robot.maps if robot.kind.changes_floors else [floor]
    graphs = {name: graph for name in floors if (graph := robot.maps.get(name, RobotMap()).graph) is not None}
    chargers = [_place(robot, name, one.id) for name, graph in graphs.items() for one in graph.chargers]
    if not chargers or floor not in graphs:
        raise CommandError(Message("no graph shows a charger on {floor}", floor=floor))

    others = [one for one in state.robots.values() if one.name != robot.name]
    taken = [(one.floor, charger.id) for one in others if (charger := charger_of(state, one)) is not None]
    free = [place for place in chargers if (place.floor, place.vertex) not in taken]
    if not free:
        raise CommandError(Message("other robots are at all chargers of {floor}", floor=floor))

    def metres(vertex: Vertex) -> float:
        return math.dist((vertex.x, vertex.y), (pose.x, pose.y))

    starts = sorted(graphs[floor].vertices.values(), key=metres)
    found = GraphDistances()
    ways = {place: metres_to(robot, floor, [(starts[0].id, 0.0)], place, found) for place in free}
    if not graphs[floor].edges:
        ways |= {one: metres(graphs[floor].vertices[one.vertex]) for one in free if one.floor == floor}
    end = min(ways, key=lambda place: ways[place])
    if (end.floor, end.vertex) == (floor, starts[0].id) and metres(starts[0]) <= AT_CHARGER:
        raise CommandError(Message("{name} is at a charger", name=robot.name))
    if not math.isfinite(ways[end]):
        raise CommandError(Message("no path on the graph leads {name} to a charger", name=robot.name))
    # An order from the charger to the charger is none.
    start = next((one.id for one in starts if (floor, one.id) != (end.floor, end.vertex)), end.vertex)
    return _place(robot, floor, start), end


def _place(robot: Robot, floor: str, vertex: str) -> Place:
    return Place(vertex, robot.maps[floor].name_of(vertex) or vertex, floor)
