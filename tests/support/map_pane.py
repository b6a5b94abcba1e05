"""The map pane in a small app, with its keys' actions."""

from dataclasses import replace

import numpy as np
from textual.app import App, ComposeResult
from textual.pilot import Pilot

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.widgets.map_view import MapView

FRAME = MapFrame(0.05, 400, 200)


def a_grid(frame: MapFrame = FRAME) -> np.ndarray:
    classes = np.full((frame.height, frame.width), FREE, np.uint8)
    classes[0] = classes[-1] = OCCUPIED
    classes[:, 0] = classes[:, -1] = OCCUPIED
    return classes


SCENE = Scene(
    "floor_0",
    FRAME,
    build_grid(FRAME, a_grid()),
    (
        SceneVertex("1", 2.0, 2.0, label="Base"),
        SceneVertex("2", 18.0, 8.0, label="Store"),
        SceneVertex("3", 10, 5),
    ),
    ((2.0, 2.0, 18.0, 8.0),),
    (SceneRobot("robot_0", 1, Pose(5.0, 5.0), selected=True), SceneRobot("robot_1", 2, Pose(15.0, 5.0))),
)


class Pane(App[None]):
    def __init__(self) -> None:
        super().__init__()
        self.map = MapView(load_themes()[0]["dark"].styles())
        self.said = ""
        self.controls = MapControls(self.map, self._say)

    def compose(self) -> ComposeResult:
        yield self.map

    def _say(self, text: str) -> None:
        self.said = text

    def rows(self) -> list[str]:
        return [self.map.render_line(y).text for y in range(self.map.size.height)]


async def started(pilot: Pilot[None]) -> tuple[Pane, MapView]:
    app = pilot.app
    assert isinstance(app, Pane)
    app.map.show(SCENE)
    await pilot.pause()
    return app, app.map


def moved(scene: Scene, x: float, y: float) -> Scene:
    first, *others = scene.robots
    return replace(scene, robots=(first._replace(pose=Pose(x, y)), *others))
