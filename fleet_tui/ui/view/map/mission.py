"""The lines of one floor: the way a robot still has to drive, and the edges that are blocked or closed."""

from collections.abc import Iterable, Iterator

from fleet_tui.commands.routes.blocked import blocked_edge
from fleet_tui.commands.routes.order_draft import Drafted
from fleet_tui.commands.routes.ways import Routes, Spot, Way, routes_of
from fleet_tui.model.desk.desk import Ends
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Line
from fleet_tui.model.order import Order, vertices_of
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.situation.traffic import stops_left
from fleet_tui.ui.view.map.scene import Mission, SceneRobot

ORDERS_SHOWN = 8


def floor_of(robot: Robot, vertex: str) -> str | None:
    """Return the floor of a vertex of the robot's orders; if ids repeat, the robot's own."""
    floors = sorted(robot.maps, key=lambda name: name != robot.floor)
    graphs = ((name, robot.maps[name].graph) for name in floors)
    return next((name for name, graph in graphs if graph is not None and vertex in graph.vertices), None)


def targets(robot: Robot, floor: str) -> tuple[str, ...]:
    """Return the vertices at which the robot's current order stops on a floor, or the first that waits."""
    first = robot.orders.current or next(iter(robot.orders.open), None)
    stops = vertices_of(first.stops) if first else ()
    return tuple(vertex for vertex in stops if floor_of(robot, vertex) == floor)


def mission(robot: Robot, floor: str) -> Mission | None:
    """Return the remaining way of the robot on a floor; a leg to or from another floor ends at an elevator.

    Cheap enough for every tick: nothing is searched again while robot and orders stay on the same edges.
    """
    orders = list(robot.orders.open[:ORDERS_SHOWN])
    routes = routes_of(robot.maps[floor]) if floor in robot.maps and orders else None
    if routes is None:
        return None
    at = _whereabouts(robot, floor, routes)
    legs = list(_legs(robot, floor, routes, orders, at))
    first = robot.orders.current or orders[0]  # a robot that is held up may list its order as waiting
    current = tuple(line for order, way in legs if order is first for line in way.lines)
    following = tuple(line for order, way in legs if order is not first for line in way.lines)
    order, way = legs[0] if legs else (orders[0], Way())
    if order is not first or robot.floor != floor or way.start is None:
        return Mission(current, following)
    return Mission(current, following, routes.edge(at, way.start))


def _legs(
    robot: Robot, floor: str, routes: Routes, orders: list[Order], at: tuple[Spot, ...]
) -> Iterator[tuple[Order, Way]]:
    """Return the ways from the robot to one stop after the other."""
    for order in orders:
        for vertex in _stops(robot, order):
            goals = _places(robot, floor, routes, vertex)
            yield order, routes.shortest(at, goals)
            at = goals


def _stops(robot: Robot, order: Order) -> tuple[str, ...]:
    """Return the remaining vertices of an order."""
    return vertices_of(stops_left(robot, order))


def _whereabouts(robot: Robot, floor: str, routes: Routes) -> tuple[Spot, ...]:
    if robot.pose is None or robot.floor is None:
        return ()
    return routes.near(robot.pose.value) if robot.floor == floor else routes.elevators


def _places(robot: Robot, floor: str, routes: Routes, vertex: str) -> tuple[Spot, ...]:
    """Return a vertex as seen from a floor: itself, the elevators if it is on another, nothing if unknown."""
    actual = floor_of(robot, vertex)
    if actual is None:
        return ()
    return ((vertex, 0.0),) if actual == floor else routes.elevators


def way_of(robot: Robot, floor: str, drafted: Drafted | None) -> tuple[tuple[str, ...], Mission | None]:
    """Return the vertices and the lines to draw on a floor: of the order being typed, else of the current."""
    if drafted is None:
        return targets(robot, floor), mission(robot, floor)
    draft, route = drafted
    places = [place for place in (*draft.places, draft.marked) if place is not None and place.floor == floor]
    if route is None:
        return tuple(place.vertex for place in places), None
    way = Mission(route.lines.get(floor, ()), route.to_start.get(floor, ()))
    return tuple(place.vertex for place in places), way if way.current or way.following else None


def blocked_edges(state: FleetState, robots: Iterable[SceneRobot]) -> Iterator[Ends]:
    """Yield the edges of a floor that may be blocked where robots with an alarm are held up."""
    for robot in robots:
        edge = blocked_edge(state, robot.name) if robot.alarmed or robot.acknowledged else None
        if edge is not None:
            yield edge


def edge_lines(robot_map: RobotMap, edges: Iterable[Ends]) -> tuple[Line, ...]:
    """Return the lines of edges of a floor, as far as they are in its graph."""
    places = robot_map.graph.vertices if robot_map.graph is not None else {}
    ends = [edge[1:] for edge in edges if places.keys() >= set(edge[1:])]
    return tuple((places[a].x, places[a].y, places[b].x, places[b].y) for a, b in ends)
