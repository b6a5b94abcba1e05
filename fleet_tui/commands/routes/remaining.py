"""The way that is left of a robot's current order."""

import math

from fleet_tui.commands.routes.order_draft import place_of, stop_at, way_between
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Robot
from fleet_tui.situation.traffic import stops_left


def metres_left(robot: Robot, order: Order) -> float | None:
    """Return the metres along the graphs from the robot to the last stop of an order, None if a part of the
    way is unknown."""
    start = place_of(robot)
    stops = [stop_at(robot, stop.vertex) for stop in stops_left(robot, order)]
    if robot.pose is None or not start or not stops or not all(stops):
        return None
    places = [place for found in stops for place in found]
    lines, metres = way_between(robot, [*start, *places])
    if metres is None:
        return None
    floor, vertices = places[0]
    graph = robot.maps[floor].graph
    first = lines.get(start[0][0])
    if first:
        x, y, *_ = first[0]
    elif graph is not None and floor == robot.floor:
        x, y = graph.vertices[vertices[0][0]].x, graph.vertices[vertices[0][0]].y
    else:
        return metres
    return metres + math.dist((robot.pose.value.x, robot.pose.value.y), (x, y))
