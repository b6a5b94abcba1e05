"""The way of a robot to a charger, and the order that leads there."""

import math

from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.graph import RouteGraph, Vertex
from fleet_tui.model.kind import ORDER_TO
from fleet_tui.model.order import at_vertices
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.rules.language.lookup import Place


def way_to_charger(robot: Robot) -> tuple[Place, ...]:
    """Return the vertex nearest to a robot and the nearest charger on its floor that it can reach from there;
    empty without one, or if it is there."""
    floor = robot.floor or ""
    here = robot.maps.get(floor, RobotMap())
    if here.graph is None or robot.pose is None or not here.graph.chargers:
        return ()
    pose = robot.pose.value

    def metres(vertex: Vertex) -> float:
        return math.dist((vertex.x, vertex.y), (pose.x, pose.y))

    start = min(here.graph.vertices.values(), key=metres)
    ways = {one.id: _metres(here.graph, start, one, metres(one)) for one in here.graph.chargers}
    nearest = min(ways, key=lambda id_: ways[id_])
    if nearest == start.id or not math.isfinite(ways[nearest]):
        return ()
    return tuple(Place(id_, here.name_of(id_) or id_, floor) for id_ in (start.id, nearest))


def _metres(graph: RouteGraph, start: Vertex, charger: Vertex, straight: float) -> float:
    """Return the metres of the way to a charger, infinite without one; without edges those to it."""
    return graph.metres_to([charger.id]).get(start.id, math.inf) if graph.edges else straight


def order_to_charger(robot: Robot) -> Request | None:
    """Return the order to the nearest charger, None if there is no way to one. A robot that brings cargo has
    orders from somewhere."""
    way = way_to_charger(robot)
    if ORDER_TO in robot.kind.accepts and not robot.kind.brings_cargo:
        way = way[-1:]
    if not way:
        return None
    stops = at_vertices(*(place.vertex for place in way))
    return Request((PlaceOrder(robot.name, stops),), tuple((one.vertex, one.floor) for one in way))


def why_no_order_to_charger(robot: Robot) -> str:
    """Return why there is no order to a charger."""
    if robot.pose is None or robot.floor is None:
        return f"the place of {robot.name} is not known"
    graph = robot.maps.get(robot.floor, RobotMap()).graph
    if graph is None or not graph.chargers:
        return f"no graph shows a charger on {robot.floor}"
    return f"{robot.name} is at a charger, or no way on the graph leads to one"
