"""The map pane in a small app: what its rows say, what it refreshes, where its camera goes."""

from collections.abc import Iterable
from dataclasses import replace

from rich.style import Style
from textual.geometry import Region

from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.occupancy import build_grid
from fleet_tui.ui.view.map.scene import Scene, SceneVertex
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.map_view import MapView, post_pick
from tests.support.map_pane import FRAME, SCENE, Pane, a_grid, moved, started


async def test_shows_floor_scale_map_graph_and_robots() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, _ = await started(pilot)
        rows = app.rows()
        assert rows[0].startswith("─ floor_0 ── 2 m ├")
        assert "follow" not in rows[0]
        assert "zoom" not in rows[0]
        text = "\n".join(rows)
        for part in ("Base", "Store", "→1", "→2", "▛", "·"):
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
        behind = view.picture.backdrop
        view.show(moved(SCENE, 7.0, 3.0))
        assert view.picture.backdrop is behind
        view.show(replace(SCENE, vertices=(*SCENE.vertices, SceneVertex("4", 1, 1))))
        assert view.picture.backdrop is not behind


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


async def test_the_focused_caption_is_bright_and_roles_change_live() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        _, view = await started(pilot)
        view.focus()
        await pilot.pause()
        bright = next(s.style for s in view.render_line(0) if "floor_0" in s.text)
        assert bright is not None
        assert bright.bold
        view.set_role_styles({role: Style(bold=True) for role in StyleRole})
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
        post_pick(view, view.picture.pick(3, 3))
        assert "floor_0" in app.rows()[0]
