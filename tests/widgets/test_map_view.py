"""The map pane in a small app: what its rows say, what it refreshes, where its camera goes."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest
from rich.style import Style
from textual.app import App, ComposeResult
from textual.geometry import Region
from textual.pilot import Pilot

from fleet_tui.controllers.map import MapControls
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.themes import load_themes
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.roles import StyleRole
from fleet_tui.widgets.map_view import MapView

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
        self.controls = MapControls(self.map)

    def compose(self) -> ComposeResult:
        yield self.map

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


async def test_shows_floor_scale_map_graph_and_robots() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, _ = await started(pilot)
        rows = app.rows()
        assert rows[0].startswith("─ floor_0 ── 2 m ├")
        assert "follow" not in rows[0]
        assert "zoom" not in rows[0]
        text = "\n".join(rows)
        for part in ("o Base", "Store", "1→", "2→", "▛", "·"):
            assert part in text
        assert all(len(row) == 100 for row in rows)


async def test_nothing_new_refreshes_nothing_and_a_move_only_its_rows() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        asked: list[tuple[Region, ...]] = []

        def refresh(*regions: Region, **_: object) -> MapView:
            asked.append(regions)
            return view

        view.refresh = refresh  # type: ignore[method-assign]  # to see what is asked for
        strips = [view.render_line(y) for y in range(30)]
        view.show(replace(SCENE))
        assert asked == []
        before = app.rows()
        view.show(moved(SCENE, 5.5, 5.0))
        changed = {y for y in range(30) if before[y] != app.rows()[y]}
        assert len(changed) == 1
        assert {region.y for regions in asked for region in regions} == changed
        assert all(region.width < 10 for regions in asked for region in regions)
        kept = [y for y in range(30) if view.render_line(y) is strips[y]]
        assert set(kept) == set(range(30)) - changed


async def test_the_backdrop_is_kept_while_only_robots_move() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        _, view = await started(pilot)
        behind = view.picture._backdrop
        view.show(moved(SCENE, 7.0, 3.0))
        assert view.picture._backdrop is behind
        view.show(replace(SCENE, vertices=(*SCENE.vertices, SceneVertex("4", 1, 1))))
        assert view.picture._backdrop is not behind


@pytest.mark.parametrize("action", ["zoom_in", "zoom_out", "edges", "labels", "drawing", "cursor"])
async def test_an_action_changes_the_picture(action: str) -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        before = app.rows(), [list(view.render_line(y)) for y in range(30)]
        getattr(app.controls, action)()
        assert (app.rows(), [list(view.render_line(y)) for y in range(30)]) != before


async def test_zoom_pan_and_fit() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        fit = app.rows()
        app.controls.zoom_in()
        app.controls.zoom_in()
        nearer = view.picture.viewport.camera(SCENE)
        app.controls.pan(1, 0)
        assert view.picture.viewport.camera(SCENE).column > nearer.column
        app.controls.fit()
        assert app.rows() == fit


async def test_zoom_about_the_robot_keeps_it_in_its_cell() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, _ = await started(pilot)
        place = next((y, row.index("1→")) for y, row in enumerate(app.rows()) if "1→" in row)
        app.controls.zoom_about()
        assert "zoom robot" in app.rows()[0]
        app.controls.zoom_in()
        row, column = next((y, row.index("1→")) for y, row in enumerate(app.rows()) if "1→" in row)
        assert abs(row - place[0]) <= 1
        assert abs(column - place[1]) <= 1


async def test_follow_keeps_the_robot_in_view_and_a_pan_lets_it_go() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        for _ in range(6):
            app.controls.zoom_in()
        app.controls.follow()
        assert "follow on" in app.rows()[0]
        alone = replace(SCENE, robots=SCENE.robots[:1])
        for step in range(40):
            view.show(moved(alone, 1.0 + step * 0.45, 5.0))
            assert any("1→" in row for row in app.rows())
        app.controls.pan(-1, 0)
        assert "follow" not in app.rows()[0]


async def test_each_floor_keeps_its_camera_and_an_unmoved_one_refits() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        app.controls.zoom_in()
        zoomed = app.rows()
        larger = MapFrame(0.05, 800, 600)
        view.show(Scene("floor_1", FRAME))
        view.show(Scene("floor_1", larger, build_grid(larger, a_grid(larger)), note="no map yet"))
        assert "floor_1" in app.rows()[0]
        assert "no map yet" in app.rows()[0]
        assert view.picture.viewport.camera(Scene("floor_1", larger)).extent == (800, 600)
        view.show(SCENE)
        assert app.rows() == zoomed


async def test_resizing_keeps_the_centre() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        app.controls.zoom_in()
        before = view.picture.viewport.camera(SCENE)
        await pilot.resize_terminal(60, 20)
        await pilot.pause()
        after = view.picture.viewport.camera(SCENE)
        assert (after.column, after.row, after.width) == (before.column, before.row, 60)
        assert len(app.rows()) == 20
        assert all(len(row) == 60 for row in app.rows())


async def test_drawing_goes_round_and_ascii_is_ascii() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        seen = [Drawing.BRAILLE]
        for _ in range(3):
            app.controls.drawing()
            seen.append(view.picture.options.drawing)
            assert "".join(app.rows()).isascii() == (seen[-1] is Drawing.ASCII)
        assert seen == [*Drawing, Drawing.BRAILLE]


async def test_the_focused_caption_is_bright_and_inks_change_live() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        _, view = await started(pilot)
        view.focus()
        await pilot.pause()
        bright = next(s.style for s in view.render_line(0) if "floor_0" in s.text)
        assert bright is not None
        assert bright.bold
        view.set_inks({ink: Style(bold=True) for ink in StyleRole})
        assert all(s.style == Style(bold=True) for y in range(30) for s in view.render_line(y))


async def test_tiny_panes_and_empty_scenes_break_nothing() -> None:
    async with Pane().run_test(size=(4, 2)) as pilot:
        app, view = await started(pilot)
        scenes: Iterable[Scene] = (SCENE, Scene("仓库\x1b[2J", MapFrame(0.05, 1, 1)), Scene("", FRAME))
        for scene in scenes:
            view.show(scene)
            for action in ("zoom_in", "zoom_out", "follow", "centre", "cursor", "pick", "drawing", "fit"):
                getattr(app.controls, action)()
            assert "\x1b" not in "".join(app.rows())


async def test_a_robot_that_is_nowhere_can_be_selected_followed_and_clicked_at() -> None:
    async with Pane().run_test(size=(60, 20)) as pilot:
        app, view = await started(pilot)
        view.show(moved(SCENE, float("nan"), float("inf")))
        for action in ("follow", "centre", "zoom_about", "zoom_in"):
            getattr(app.controls, action)()
        view.post_pick(view.picture.pick(3, 3))
        assert "floor_0" in app.rows()[0]


async def test_a_robot_that_is_selected_comes_into_view_and_one_in_view_moves_nothing() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        for _ in range(6):
            app.controls.zoom_in()
        view.show(moved(SCENE, 19.0, 9.0))
        assert not any("1→" in row for row in app.rows())
        app.controls.reveal()
        assert any("1→" in row for row in app.rows())
        before = app.rows()
        app.controls.reveal()
        assert app.rows() == before
