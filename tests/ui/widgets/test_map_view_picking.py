"""Pointing at the map, by mouse and by its cursor."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from textual.app import App, ComposeResult
from textual.events import MouseScrollUp
from textual.message import Message
from textual.pilot import Pilot

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.widgets.map_view import MapView
from fleet_tui.ui.widgets.messages import RobotPicked, VertexPicked

SCENE = Scene(
    "floor_0",
    MapFrame(0.05, 400, 200),
    vertices=(SceneVertex("1", 2.0, 2.0, label="Base"), SceneVertex("2", 18.0, 8.0, label="Store")),
    robots=(SceneRobot("robot_1", 2, Pose(15.0, 5.0)),),
)


class Pane(App[None]):
    def __init__(self) -> None:
        super().__init__()
        self.map = MapView()
        self.controls = MapControls(self.map)
        self.picked: list[Message] = []

    def compose(self) -> ComposeResult:
        yield self.map

    def on_robot_picked(self, message: RobotPicked) -> None:
        self.picked.append(message)

    def on_vertex_picked(self, message: VertexPicked) -> None:
        self.picked.append(message)

    def rows(self) -> list[str]:
        return [self.map.render_line(y).text for y in range(self.map.size.height)]


@asynccontextmanager
async def started() -> AsyncIterator[tuple[Pilot[None], Pane, MapView]]:
    app = Pane()
    async with app.run_test(size=(100, 30)) as pilot:
        app.map.show(SCENE)
        await pilot.pause()
        yield pilot, app, app.map


async def test_clicks_pick_and_drags_pan() -> None:
    async with started() as (pilot, app, view):
        rows = app.rows()
        robot = next((row.index("→2"), y) for y, row in enumerate(rows) if "→2" in row)
        vertex = next((row.index("o Base"), y) for y, row in enumerate(rows) if "o Base" in row)
        await pilot.click(MapView, offset=robot)
        await pilot.click(MapView, offset=vertex)
        await pilot.pause()
        assert isinstance(app.picked[0], RobotPicked)
        assert app.picked[0].name == "robot_1"
        assert isinstance(app.picked[1], VertexPicked)
        assert app.picked[1].id == "1"
        app.controls.zoom_in()
        centre = view.picture.viewport.camera(SCENE).column
        await pilot.mouse_down(MapView, offset=(50, 15))
        await pilot.hover(MapView, offset=(40, 15))
        await pilot.mouse_up(MapView, offset=(40, 15))
        await pilot.pause()
        assert view.picture.viewport.camera(SCENE).column > centre
        assert len(app.picked) == 2


async def test_the_cursor_visits_labelled_vertices_and_picks() -> None:
    async with started() as (pilot, app, view):
        for step, id_ in ((1, "1"), (1, "2"), (1, "1"), (-1, "2")):
            app.controls.next_vertex(step)
            app.controls.pick()
            await pilot.pause()
            message = app.picked[-1]
            assert isinstance(message, VertexPicked)
            assert message.id == id_
        app.controls.pan(1, 0)
        app.controls.cursor()
        assert view.picture.options.cursor is None


async def test_the_wheel_zooms_and_what_is_under_the_pointer_stays() -> None:
    async with started() as (pilot, app, view):
        rows = app.rows()
        vertex = next((row.index("o Base"), y) for y, row in enumerate(rows) if "o Base" in row)
        before = view.picture.viewport.camera(SCENE).scale
        for event in (MouseScrollUp, MouseScrollUp):
            view.post_message(event(view, *vertex, 0, -1, 0, False, False, False, *vertex))
        await pilot.pause()
        assert view.picture.viewport.camera(SCENE).scale < before * 0.6
        x, y = view.picture.viewport.camera(SCENE).to_cell(*SCENE.frame.to_pixel(2.0, 2.0))
        assert abs(x - vertex[0]) <= 2
        assert abs(y + 1 - vertex[1]) <= 2


async def test_a_label_is_as_good_a_target_as_its_vertex() -> None:
    async with started() as (pilot, app, _):
        label = next((row.index("Store") + 3, y) for y, row in enumerate(app.rows()) if "Store" in row)
        await pilot.click(MapView, offset=label)
        await pilot.pause()
        assert [getattr(one, "id", "") for one in app.picked] == ["2"]
