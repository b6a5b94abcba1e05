"""Actions on the map: what each changes, and where the camera goes."""

from dataclasses import replace

import pytest

from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.map_pane import SCENE, Pane, moved, started


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
        place = next((y, row.index("→1")) for y, row in enumerate(app.rows()) if "→1" in row)
        app.controls.zoom_about()
        assert app.said == "zooming keeps the robot in place"
        assert "zoom robot" in app.rows()[0]
        app.controls.zoom_in()
        row, column = next((y, row.index("→1")) for y, row in enumerate(app.rows()) if "→1" in row)
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
            assert any("→1" in row for row in app.rows())
        app.controls.pan(-1, 0)
        assert "follow" not in app.rows()[0]


async def test_drawing_goes_round_and_ascii_is_ascii() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        seen = [Drawing.BRAILLE]
        for _ in range(3):
            app.controls.drawing()
            seen.append(view.picture.options.drawing)
            assert app.said == f"drawing: {seen[-1].value}"
            assert "".join(app.rows()).isascii() == (seen[-1] is Drawing.ASCII)
        assert seen == [*Drawing, Drawing.BRAILLE]


async def test_a_robot_that_is_selected_comes_into_view_and_one_in_view_moves_nothing() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        for _ in range(6):
            app.controls.zoom_in()
        view.show(moved(SCENE, 19.0, 9.0))
        assert not any("→1" in row for row in app.rows())
        app.controls.reveal()
        assert any("→1" in row for row in app.rows())
        before = app.rows()
        app.controls.reveal()
        assert app.rows() == before


async def test_to_follow_a_robot_that_is_not_here_says_when_it_begins() -> None:
    said = list[str]()
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, view = await started(pilot)
        controls = MapControls(view, said.append)
        view.show(replace(SCENE, robots=SCENE.robots[1:]))
        controls.follow()
        assert said == ["the map follows the robot wherever its position is known"]
        controls.follow()
        view.show(SCENE)
        controls.follow()
        assert len(said) == 1
        assert "follow on, all in view" in app.rows()[0]
        for _ in range(4):
            controls.zoom_in()
        assert "follow on" in app.rows()[0] and "all in view" not in app.rows()[0]


async def test_to_look_elsewhere_while_following_says_that_it_ends() -> None:
    said = list[str]()
    async with Pane().run_test(size=(100, 30)) as pilot:
        _, view = await started(pilot)
        controls = MapControls(view, said.append)
        controls.stop_following()
        controls.follow()
        controls.stop_following()
        assert said == ["follow off"] and not view.picture.viewport.follow


async def test_the_closer_the_view_the_smaller_the_area_and_the_cells() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        app, _ = await started(pilot)
        whole = app.controls.seen()
        app.controls.zoom_in()
        nearer = app.controls.seen()
        assert whole is not None and nearer is not None
        assert nearer.cell < whole.cell and nearer.right - nearer.left < whole.right - whole.left
