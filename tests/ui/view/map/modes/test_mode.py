"""Modes of the map: what arrows and Enter mean in each, and what it shows."""

import pytest

from fleet_tui.model.geometry import MapFrame
from fleet_tui.ui.view.map.layers import draw_cursor
from fleet_tui.ui.view.map.modes.mode import CursorMode, MapMode, ViewMode
from fleet_tui.ui.view.map.scene import Scene, SceneVertex
from fleet_tui.ui.view.map.viewport import Viewport

SCENE = Scene(
    "floor_0", MapFrame(0.05, 400, 400), None, (SceneVertex("7", 10.0, 10.0, label="Base"),), (), ()
)


@pytest.fixture
def view() -> Viewport:
    view = Viewport()
    view.width, view.height = 80, 24
    return view


def test_in_the_view_mode_arrows_move_the_view_and_enter_picks_nothing(view: Viewport) -> None:
    mode: MapMode = ViewMode()
    before = view.middle(SCENE)
    view.zoom(SCENE, 4.0)
    mode.move(view, SCENE, 1, 0)
    assert view.middle(SCENE)[0] > before[0]
    assert (mode.pick(view, SCENE), mode.cursor, mode.banner("floor_0"), mode.layers) == (None, None, "", ())


def test_in_the_cursor_mode_arrows_move_the_cursor_and_the_view_stays(view: Viewport) -> None:
    mode: MapMode = CursorMode(view.middle(SCENE))
    before, middle = mode.cursor, view.middle(SCENE)
    mode.move(view, SCENE, 3, 0)
    assert mode.cursor is not None and before is not None and mode.cursor[0] > before[0]
    assert view.middle(SCENE) == middle
    assert mode.layers == (draw_cursor,)


def test_the_cursor_picks_the_vertex_that_it_is_on_and_says_where_it_is(view: Viewport) -> None:
    mode = CursorMode((10.0, 10.0))
    assert mode.pick(view, SCENE) is SCENE.vertices[0]
    assert mode.banner("floor_0") == "x 10.0 y 10.0 m"
    assert CursorMode((-0.01, 2.0)).banner("floor_0") == "x 0.0 y 2.0 m"
    assert CursorMode((1.0, 1.0)).pick(view, SCENE) is None
