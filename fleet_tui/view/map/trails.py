"""Trails: the recent positions of the robots of each floor."""

import math

import numpy as np
from numpy.typing import NDArray

from fleet_tui.view.map.scene import Scene

SECONDS = 60.0
STEP = 0.5
"""Metres between two points of a robot's trail."""
POINTS = 128
"""The maximum number of points of one robot."""
EVERY = 0.25
"""Seconds between two samples: at 2 m/s a robot is sampled every STEP."""


class Trails:
    """The last points of every robot, by floor and name: a bounded number of each, however it jumps."""

    def __init__(self) -> None:
        self._rings: dict[tuple[str, str], _Ring] = {}
        self._looked: tuple[str, float] = ("", -math.inf)

    def note(self, scene: Scene) -> None:
        """Record the positions of the scene's robots."""
        floor, at = self._looked
        if floor == scene.floor and 0.0 <= scene.at - at < EVERY:
            return
        self._looked = scene.floor, scene.at
        for robot in scene.robots:
            x, y = robot.pose.x, robot.pose.y
            if robot.online and math.isfinite(x) and math.isfinite(y):
                ring = self._rings.get((scene.floor, robot.name))
                if ring is None:
                    ring = self._rings[scene.floor, robot.name] = _Ring()
                ring.note(x, y, scene.at)

    def of(self, scene: Scene) -> NDArray[np.float64]:
        """Return the points of the scene's floor: rows of x, y in metres and the age in seconds."""
        rings = [ring.points for (floor, _), ring in self._rings.items() if floor == scene.floor]
        if not rings:
            return np.zeros((0, 3))
        points = np.concatenate(rings)
        points[:, 2] = scene.at - points[:, 2]
        return points[points[:, 2] <= SECONDS]


class _Ring:
    """Rows of x, y and the second; the newest replaces the oldest."""

    def __init__(self) -> None:
        self.points = np.full((POINTS, 3), -math.inf)
        self._next = 0
        self._last = (math.inf, math.inf)

    def note(self, x: float, y: float, at: float) -> None:
        """Record a position that is far enough from the last one."""
        if math.dist((x, y), self._last) >= STEP:
            self.points[self._next] = x, y, at
            self._next = (self._next + 1) % POINTS
            self._last = (x, y)
