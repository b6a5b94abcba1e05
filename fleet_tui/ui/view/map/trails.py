"""Trails: the recent positions of the robots of each floor."""

import math

import numpy as np
from numpy.typing import NDArray

from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.lines import stroke
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.map.tracing import blank_mask, dots_of, set_dots
from fleet_tui.ui.view.roles import StyleRole

SECONDS = 60.0
STEP = 0.5
"""Metres between two points of a robot's trail."""
POINTS = 128
"""The maximum number of points of one robot."""
FADED = 30.0
"""Seconds after which a trail is paler and has half as many dots."""
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


def draw_trails(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw trails as dots that pale and thin out with age."""
    if scene.trail is None or not len(scene.trail):
        return
    dots, old = dots_of(scene, camera, scene.trail[:, :2]), scene.trail[:, 2] > FADED
    # By place, so that a dot does not flicker with its neighbours.
    thinned = old & (np.floor(dots).sum(axis=1) % 2 == 0)
    for some, role in ((old & ~thinned, StyleRole.TRAIL_OLD), (~old, StyleRole.TRAIL)):
        mask = blank_mask(camera)
        set_dots(mask, dots[some])
        stroke(cells, mask, role, look, ",")
