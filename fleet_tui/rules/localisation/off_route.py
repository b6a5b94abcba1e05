"""How far a robot is from the edges on which it drives."""

from fleet_tui.model.geometry import metres_from
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.robot import Robot, RobotMap

OFF_GRAPH = 2.0
"""Metres from the nearest edge that no detour around an obstacle explains."""


def graph_here(robot: Robot) -> RouteGraph | None:
    """Return the robot's own graph of its floor."""
    return robot.maps.get(robot.floor or "", RobotMap()).graph


def metres_off(robot: Robot) -> float:
    """Return the metres from a robot to the nearest edge of its graph here, 0 without one."""
    graph = graph_here(robot)
    if graph is None or robot.pose is None:
        return 0.0
    at, places = (robot.pose.value.x, robot.pose.value.y), graph.vertices
    edges = (one for one in graph.edges if one.start in places and one.end in places)
    ends = ((places[one.start], places[one.end]) for one in edges)
    return min((metres_from(at, (one.x, one.y, end.x, end.y)) for one, end in ends), default=0.0)


def is_off_route(robot: Robot) -> bool:
    """Tell whether a robot with an order that drives only on edges is beside all of them."""
    drives = robot.orders.current is not None and not robot.kind.keeps_goals and robot.vehicle is None
    return drives and metres_off(robot) >= OFF_GRAPH
