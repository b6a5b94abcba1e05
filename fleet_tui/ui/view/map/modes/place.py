"""The map mode in which a place with a heading is chosen: a pose of a robot, or a goal."""

import math
from dataclasses import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layer_stack import Layer
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.modes.mode import PlainMode, place_text
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.map.viewport import Point, Viewport
from fleet_tui.ui.view.roles import StyleRole

_ARROWS = ("→↗↑↖←↙↓↘", ">/^\\</v\\")
"""East first, then counter-clockwise in steps of 45 degrees; the second in ASCII."""
_LENGTH = 3
"""Cells of the line that shows the heading, in a row."""


class PlaceMode(PlainMode):
    """Arrows move the cursor; `yaw` is the heading in radians. `title` names what is placed, `note` goes with
    the pose; with `moves_scan` the laser scan is drawn as seen from there."""

    points = False

    def __init__(self, title: Message, robot: str, floor: str, pose: Pose, moves_scan: bool = False) -> None:
        self.title = title
        self.robot = robot
        self.floor = floor
        self.note = EMPTY
        self.moves_scan = moves_scan
        self.put(pose)
        self.layers: tuple[Layer, ...] = (self._draw,)

    @property
    def pose(self) -> Pose:
        return Pose(*self.cursor, self.yaw)

    def banner(self, shown: str) -> str:
        """Return the chosen pose: its place and match first, the heading is seen on the map, too."""
        place = place_text(translate(self.title), self.floor, shown, self.cursor)
        degrees = tr("{degrees} degrees", degrees=round(math.degrees(self.yaw)) + 0)
        return ", ".join(filter(None, (place, translate(self.note), degrees, sanitize(self.robot))))

    def adjusted(self, scene: Scene) -> Scene:
        """Return the scene with the laser scan as it would lie with the robot at the chosen pose."""
        if scene.floor != self.floor or not self.moves_scan or scene.beams is None:
            return scene
        return replace(scene, beams_at=self.pose)

    def put(self, pose: Pose) -> None:
        self.cursor: Point = (pose.x, pose.y)
        self.yaw = pose.yaw

    def turn(self, degrees: float) -> None:
        """Turn counter-clockwise."""
        self.yaw = math.remainder(self.yaw + math.radians(degrees), math.tau)

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Move the cursor; at the edge the view moves with it."""
        self.cursor = view.stepped(scene, self.cursor, dx, dy)

    def pick(self, view: Viewport, scene: Scene) -> None:
        """Pick nothing: Enter sends."""

    def press(self, view: Viewport, scene: Scene, at: Point) -> bool:
        """Put the cursor there; a drag from there sets the heading."""
        self.cursor = at
        return True

    def drag(self, at: Point) -> None:
        """Turn the heading to a place."""
        if math.dist(at, self.cursor) > 0:
            self.yaw = math.atan2(at[1] - self.cursor[1], at[0] - self.cursor[0])

    def _draw(self, cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
        """Draw the chosen pose: an arrow, and dots along its heading."""
        if scene.floor != self.floor:
            return
        frame, (x, y) = scene.frame, self.cursor
        cell = 2 * camera.scale * frame.resolution
        for step in range(_LENGTH, 0, -1):
            ahead = x + math.cos(self.yaw) * cell * 2 * step, y + math.sin(self.yaw) * cell * 2 * step
            column, row = camera.to_cell(*frame.to_pixel(*ahead))
            if camera.shows(column, row):
                cells.write(column, row, "*" if look.plain else "•", StyleRole.TARGET)
        column, row = camera.to_cell(*frame.to_pixel(x, y))
        if camera.shows(column, row):
            eighth = round((self.yaw - frame.origin.yaw) / (math.pi / 4)) % 8
            cells.write(column, row, _ARROWS[look.plain][eighth], StyleRole.CURSOR)
