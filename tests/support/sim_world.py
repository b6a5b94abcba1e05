"""A world of one simulated robot of the source's stack."""

import math
from typing import Any

from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot

Values = dict[str, Any]


def call(world: World, verb: str, robot: str = "robot_0", **args: object) -> Values:
    return world.answer(f"/{robot}/Application_layout/{verb}", args)


def order(world: World, start: int, end: int, robot: str = "robot_0") -> Values:
    return call(world, "Execute_order", robot, request_id=5, initial_point=start, end_point=end)


def off_road(world: World, robot: SimRobot) -> float:
    """Metres between a robot and the nearest edge of the floor it says it is on."""
    vertices = robot.floor.graph.vertices
    distances = []
    for edge in robot.floor.graph.edges:
        start, end = vertices[edge.start], vertices[edge.end]
        dx, dy = end.x - start.x, end.y - start.y
        along = ((robot.pose.x - start.x) * dx + (robot.pose.y - start.y) * dy) / (dx * dx + dy * dy)
        along = min(1.0, max(0.0, along))
        spot = (start.x + along * dx, start.y + along * dy)
        distances.append(math.dist(spot, (robot.pose.x, robot.pose.y)))
    return min(distances)


def run_until_idle(world: World, robot: SimRobot, seconds: float = 400.0) -> None:
    end = world.time + seconds
    while robot.orders:
        assert world.time < end, f"{robot.name} still has {robot.orders}"
        world.step(0.5)
