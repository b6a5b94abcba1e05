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
    at = robot.pose.value.x, robot.pose.value.y
    return min((metres_from(at, line) for line in graph.lines), default=0.0)


def is_off_route(robot: Robot) -> bool:
    """Tell whether a robot with an order that drives only on edges is beside all of them."""
    drives = robot.orders.current is not None and not robot.kind.keeps_goals and robot.vehicle is None
    graph = graph_here(robot) if drives else None
    if graph is None or robot.pose is None or not graph.lines:
        return False
    # Nearly always one is near: this is asked of a hundred robots of a crowd in a tick.
    x, y, far = robot.pose.value.x, robot.pose.value.y, OFF_GRAPH
    return not any(
        min(x0, x1) - far < x < max(x0, x1) + far
        and min(y0, y1) - far < y < max(y0, y1) + far
        and metres_from((x, y), (x0, y0, x1, y1)) < far
        for x0, y0, x1, y1 in graph.lines
    )
