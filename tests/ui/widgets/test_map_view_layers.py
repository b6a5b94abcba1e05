"""Temporary layers of the map pane: trails, cursor, turn, a map that grows."""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from msgspec import structs
from textual.app import App, ComposeResult
from textual.pilot import Pilot

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, build_grid
from fleet_tui.ui.controllers import map as map_controls
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.map_view import MapView

FRAME = MapFrame(0.05, 400, 200)
SCENE = Scene(
    "floor_0",
    FRAME,
    vertices=(SceneVertex("1", 2.0, 2.0, label="Base"), SceneVertex("2", 18.0, 8.0, label="Store")),
    robots=(SceneRobot("robot_0", 1, Pose(3.0, 5.0), selected=True),),
)


class Pane(App[None]):
    def __init__(self) -> None:
        super().__init__()
        self.map = MapView()

    def compose(self) -> ComposeResult:
        yield self.map


async def started(pilot: Pilot[None], scene: Scene = SCENE) -> MapView:
    app = pilot.app
    assert isinstance(app, Pane)
    app.map.show(scene)
    await pilot.pause()
    return app.map


def caption(view: MapView) -> str:
    return view.render_line(0).text


def roles(view: MapView) -> set[int]:
    assert view.painted is not None
    return set(view.painted.roles.ravel().tolist())


def driven(metres: float) -> Scene:
    return replace(SCENE, robots=(SCENE.robots[0]._replace(pose=Pose(3.0 + metres, 5.0)),), at=metres)


async def test_trails_are_off_until_asked_for_and_then_tell_of_the_last_minute() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot)
        controls = MapControls(view)
        for step in range(100):
            view.show(driven(step / 10))
        assert not roles(view) & {StyleRole.TRAIL, StyleRole.TRAIL_OLD}
        controls.trails()
        assert StyleRole.TRAIL in roles(view)
        view.show(replace(driven(9.9), at=50.0))
        assert StyleRole.TRAIL_OLD in roles(view)
        view.show(replace(driven(9.9), at=200.0))
        assert not roles(view) & {StyleRole.TRAIL, StyleRole.TRAIL_OLD}
        controls.trails()
        assert not view.picture.options.trails


async def test_the_backdrop_stands_while_the_robot_drives_to_where_its_mission_begins() -> None:
    lines = ((5.0, 5.0, 18.0, 8.0),)
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot, replace(SCENE, mission=Mission(lines, (), (3.0, 5.0, 5.0, 5.0))))
        controls = MapControls(view)
        behind = view.picture.backdrop
        controls.trails()
        view.show(replace(driven(1.0), mission=Mission(lines, (), (3.0, 5.0, 5.0, 5.0))))
        assert view.picture.backdrop is behind
        view.show(replace(driven(2.5), mission=Mission(lines, (), (5.0, 5.0, 18.0, 8.0))))
        assert view.picture.backdrop is behind
        view.show(replace(driven(2.5), mission=Mission((), lines)))
        assert view.picture.backdrop is not behind


async def test_a_note_that_is_too_long_for_the_caption_is_cut() -> None:
    async with Pane().run_test(size=(60, 20)) as pilot:
        view = await started(pilot, replace(SCENE, note=f"graph routes.json: {'x' * 200}"))
        assert f" {SCENE.floor} " in caption(view) and " graph routes.json: xxx" in caption(view)
        assert caption(view).rstrip("─ ").endswith("x…")


async def test_the_caption_tells_where_the_cursor_is_in_metres_while_it_is_on() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot)
        controls = MapControls(view)
        assert " m " in caption(view)
        assert " x " not in caption(view)
        controls.next_vertex(1)
        assert " x 2.0 y 2.0 m " in caption(view)
        controls.next_vertex(1)
        assert " x 18.0 y 8.0 m " in caption(view)
        controls.cursor()
        assert " x " not in caption(view)


@pytest.mark.parametrize(
    ("degrees", "text"), [(12.0, " yaw 12° "), (-90.0, " yaw -90° "), (0.2, ""), (0.0, "")]
)
async def test_the_caption_tells_how_the_picture_is_turned(degrees: float, text: str) -> None:
    turned = structs.replace(FRAME, origin=Pose(0.0, 0.0, math.radians(degrees)))
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot, replace(SCENE, frame=turned))
        controls = MapControls(view)
        assert text in caption(view)
        assert ("yaw" in caption(view)) == bool(text)
        for _ in range(2):
            controls.drawing()
        assert caption(view).isascii()


def grown(left: int, low: int, width: int, height: int) -> Scene:
    """The floor after mapping went on: more pixels to the left, below, and in all."""
    frame = MapFrame(0.05, width, height, Pose(-0.05 * left, -0.05 * low))
    grid = build_grid(frame, np.full((height, width), FREE, np.uint8))
    return replace(SCENE, frame=frame, grid=grid)


async def test_a_map_that_grows_keeps_the_place_in_the_middle_and_the_cursor() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot, grown(0, 0, 400, 200))
        controls = MapControls(view)
        for _ in range(3):
            controls.zoom_in()
        controls.next_vertex(1)
        controls.next_vertex(1)
        before = view.picture.viewport.camera(view.picture.scene or SCENE)
        middle = FRAME.to_world(before.column, before.row)
        for scene in (grown(40, 0, 440, 200), grown(40, 80, 700, 300), grown(300, 80, 960, 300)):
            view.show(scene)
            camera = view.picture.viewport.camera(scene)
            assert scene.frame.to_world(camera.column, camera.row) == pytest.approx(middle)
            assert camera.scale == pytest.approx(before.scale)
            assert " x 18.0 y 8.0 m " in caption(view)
            rows = [view.render_line(y).text for y in range(30)]
            assert any("Store" in row for row in rows)


async def test_a_cursor_left_behind_starts_again_in_the_middle() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot)
        controls = MapControls(view)
        for _ in range(4):
            controls.zoom_in()
        controls.next_vertex(1)
        view.picture.viewport.centre(SCENE, (18.0, 8.0))
        controls.pan(1, 0)
        camera, cursor = view.picture.viewport.camera(SCENE), view.picture.options.cursor
        assert cursor is not None
        assert camera.to_cell(*FRAME.to_pixel(*cursor)) == (camera.width // 2, camera.height // 2)


async def test_the_view_moves_faster_while_a_key_is_held(monkeypatch: pytest.MonkeyPatch) -> None:
    def seconds() -> Iterator[float]:
        for n in range(1, 1000):
            yield n * 0.03

    async with Pane().run_test(size=(100, 30)) as pilot:
        view = await started(pilot)
        controls = MapControls(view)
        for _ in range(6):
            controls.zoom_in()
        monkeypatch.setattr(map_controls, "monotonic", seconds().__next__)
        places = []
        for _ in range(12):
            controls.pan(1, 0)
            places.append(view.picture.viewport.camera(SCENE).column)
        steps = [after - before for before, after in pairwise(places)]
        assert steps[-1] == pytest.approx(4 * steps[0])
