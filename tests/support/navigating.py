"""A robot that drives to poses, on the ground floor of the simulated warehouse."""

import random

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.warehouse import SimFloor, build_building

FLOOR: SimFloor = build_building(1).floors[0]


def robot(index: int = 0, at: Pose | None = None) -> NavigatingRobot:
    """A robot that stands at the first vertex, quiet."""
    spot = FLOOR.graph.vertices[min(FLOOR.graph.vertices)]
    return NavigatingRobot(index, FLOOR, at or Pose(spot.x, spot.y), random.Random(1), quiet=True)


def lived(robot: NavigatingRobot, seconds: float) -> NavigatingRobot:
    for _ in range(round(seconds / 0.05)):
        robot.step()
    return robot
