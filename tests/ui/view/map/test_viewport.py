"""The viewport: what follows, what stays, what a click means."""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.view.map.area import worth_seeing
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.ground.raster import ground
from fleet_tui.ui.view.map.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.map.viewport import Viewport, pick, pointed
from fleet_tui.ui.view.roles import WALLS

FRAME = MapFrame(0.05, 800, 400, Pose(0.0, 0.0))
ROBOT = SceneRobot("robot_0", 1, Pose(35.0, 5.0), selected=True)
VERTICES = (SceneVertex("1", 10.0, 10.0, Role.PLAIN, "Base"), SceneVertex("2", 30.0, 10.0, Role.PLAIN, ""))


def scene(*robots: SceneRobot) -> Scene:
    return Scene("hall", FRAME, vertices=VERTICES, robots=robots)


def view(follow: bool = False) -> Viewport:
    return Viewport(width=60, height=20, follow=follow)


def test_a_floor_that_nobody_moved_is_shown_as_a_whole_and_fit_brings_that_back() -> None:
    it, hall = view(), scene()
    whole = it.camera(hall)
    it.pan(hall, 5, 0)
    it.zoom(hall, 2.0)
    assert it.camera(hall) != whole
    it.fit(hall)
    assert it.camera(hall) == whole


def mapped(left: float, bottom: float, right: float, top: float) -> Scene:
    """A floor of which so much is mapped, in metres."""
    width, height = round((right - left) / 0.05), round((top - bottom) / 0.05)
    frame = MapFrame(0.05, width, height, Pose(left, bottom))
    grid = build_grid(frame, np.ones((height, width), np.uint8))
    return Scene("hall", frame, grid, area=(0.0, 0.0, float(width), float(height)))


def test_over_a_map_that_grows_the_view_rarely_moves_and_always_shows_all_of_it() -> None:
    it, seen = view(), list[tuple[int, int]]()
    for step in range(40):
        hall = mapped(-2.0 - step / 5, -1.0 - step / 10, 2.0 + step / 2, 1.0 + step / 4)
        camera, frame = it.camera(hall), hall.frame
        for corner in ((0.0, 0.0), (float(frame.width), float(frame.height))):
            assert camera.shows(*camera.to_cell(*corner))
        seen.append(camera.to_cell(*frame.to_pixel(0.0, 0.0)))
        assert camera == it.camera(hall)
    # By a cell it moves: cells are counted from the map's corner, which is not a whole cell further.
    moves = sum(max(abs(x - next_x), abs(y - next_y)) > 1 for (x, y), (next_x, next_y) in pairwise(seen))
    assert 0 < moves <= 8


def test_a_robot_followed_on_another_floor_keeps_the_zoom() -> None:
    it, hall = view(follow=True), scene(ROBOT)
    finer = MapFrame(0.025, 800, 400, Pose(0.0, 0.0))
    cellar = Scene("cellar", finer, robots=(SceneRobot("robot_0", 1, Pose(15.0, 5.0), selected=True),))
    whole = it.camera(cellar)
    it.camera(hall)
    it.zoom(hall, 4.0)
    near = it.camera(hall)
    camera = it.camera(cellar)
    assert camera.scale * finer.resolution == pytest.approx(near.scale * FRAME.resolution)
    assert camera.scale < whole.scale and camera.shows(*camera.to_cell(*finer.to_pixel(15.0, 5.0)))
    it.fit(hall)
    whole = it.camera(hall)
    it.follow = True
    assert it.camera(hall).scale == whole.scale == view().camera(hall).scale


def test_a_view_that_follows_keeps_the_robot_in_it_until_it_is_moved_by_hand() -> None:
    it, hall = view(follow=True), scene(ROBOT)
    it.zoom(hall, 8.0)
    camera = it.camera(hall)
    assert camera.shows(*camera.to_cell(*FRAME.to_pixel(35.0, 5.0)))
    it.pan(hall, -1, 0)
    assert not it.follow


def test_zooming_in_does_not_lose_the_selected_robot_and_a_fitted_view_stays_fitted() -> None:
    it, hall = view(), scene(ROBOT)
    whole = it.camera(hall)
    it.centre(hall)
    it.width, it.height = 40, 10
    assert it.camera(hall) != whole and it.camera(hall).scale > whole.scale
    for _ in range(6):
        it.zoom(hall, 1.5)
        camera = it.camera(hall)
        assert camera.shows(*camera.to_cell(*FRAME.to_pixel(35.0, 5.0)))
    it.pan(hall, -60, 0)
    middle = it.middle(hall)
    it.zoom(hall, 1.2)
    assert abs(it.middle(hall)[0] - middle[0]) < 0.5


@pytest.mark.parametrize("follow", [False, True])
def test_a_small_view_that_shows_all_stays_fitted_when_it_is_centred(follow: bool) -> None:
    it, hall = Viewport(width=39, height=16, follow=follow), mapped(0.0, 0.0, 40.0, 33.0)
    hall = replace(hall, robots=(ROBOT,))
    whole = it.camera(hall)
    it.centre(hall)
    assert it.camera(hall) == whole
    it.width, it.height = 96, 40
    assert it.camera(hall).scale < whole.scale / 2 and it.camera(hall).tall == 1.0


@given(
    st.integers(60, 3000), st.integers(60, 3000), st.integers(30, 60), st.integers(10, 19), st.integers(2, 4)
)
def test_a_small_view_shows_the_walls_on_all_sides(
    columns: int, rows: int, width: int, height: int, thick: int
) -> None:
    classes = np.full((rows, columns), FREE, np.uint8)
    classes[:thick] = classes[-thick:] = classes[:, :thick] = classes[:, -thick:] = OCCUPIED
    frame = MapFrame(0.1, columns, rows)
    grid = build_grid(frame, classes)
    hall = Scene("hall", frame, grid)
    camera = Viewport(width, height).camera(replace(hall, area=worth_seeing(hall, ())))
    cells = ground(grid, camera, Drawing.BRAILLE)
    walls = np.isin(cells.roles, WALLS) & (cells.codes != ord(" "))
    (left, top), (right, bottom) = camera.to_cell(0, 0), camera.to_cell(columns - 1e-6, rows - 1e-6)
    x, y = (left + right) // 2, (top + bottom) // 2
    for side in (walls[: top + 2, x], walls[bottom - 1 :, x], walls[y, : left + 2], walls[y, right - 1 :]):
        assert side.any()


def test_zoomed_out_as_far_as_the_whole_floor_all_of_it_is_shown() -> None:
    it, hall = view(), scene(ROBOT)
    whole = it.camera(hall)
    for factor in (2.0, 2.0, 0.5, 0.5):
        it.zoom(hall, factor)
        if factor > 1.0:
            it.pan(hall, 4, 0)
    assert it.camera(hall) == whole


FAR = SceneVertex("far", 39.0, 1.0)


def held(scene: Scene, prepare: Callable[[Viewport, Scene], object]) -> tuple[Viewport, Camera, Camera]:
    """A view whose lower half is covered: with its cameras before and while it is."""
    it = view()
    it.camera(scene)
    prepare(it, scene)
    before = it.camera(scene)
    it.holds, it.height = True, 8
    return it, before, it.camera(scene)


def seen(camera: Camera, x: float, y: float) -> bool:
    return camera.shows(*camera.to_cell(*FRAME.to_pixel(x, y)))


@pytest.mark.parametrize("prepare", [lambda *_: None, lambda it, hall: it.zoom(hall, 1.5)])
def test_a_covered_view_keeps_its_scale_and_shows_robot_and_picked_vertex(
    prepare: Callable[[Viewport, Scene], object],
) -> None:
    hall = replace(mapped(0.0, 0.0, 40.0, 20.0), vertices=(*VERTICES, FAR), robots=(ROBOT,))
    it, before, part = held(hall, prepare)
    assert part.scale == before.scale and seen(part, 35.0, 5.0)
    near = it.camera(replace(hall, picked="far"))
    assert near.scale == before.scale and seen(near, 35.0, 5.0) and seen(near, 39.0, 1.0)
    it.holds, it.height = False, 20
    assert it.camera(hall) == before


def test_without_space_for_both_a_covered_view_shows_the_picked_vertex() -> None:
    top = SceneVertex("top", 2.0, 19.0)
    hall = replace(mapped(0.0, 0.0, 40.0, 20.0), vertices=(top,), robots=(ROBOT,), picked="top")
    _, before, part = held(hall, lambda *_: None)
    assert part.scale == before.scale and seen(part, 2.0, 19.0) and not seen(part, 35.0, 5.0)


def test_the_place_under_the_pointer_stays_where_it_is() -> None:
    it, hall = view(), scene()
    place = it.camera(hall).to_pixel(10, 5)
    it.zoom(hall, 2.0, (10, 5))
    assert it.camera(hall).to_cell(*place) == (10, 5)


def test_the_cursor_takes_the_view_along_at_its_edge() -> None:
    it, hall = view(), scene()
    it.zoom(hall, 4.0)
    cursor = it.middle(hall)
    before = it.camera(hall)
    for _ in range(60):
        cursor = it.stepped(hall, cursor, 1, 0)
    after = it.camera(hall)
    assert after != before and after.shows(*after.to_cell(*FRAME.to_pixel(*cursor)))


def test_labelled_vertices_are_gone_through_and_brought_into_view() -> None:
    it, hall = view(), scene()
    assert it.next_labelled(hall, None, 1) == (10.0, 10.0)
    assert it.next_labelled(Scene("hall", FRAME), None, 1) is None


def test_a_click_means_the_robot_then_the_label_then_the_vertex() -> None:
    it, hall = view(), scene(SceneRobot("robot_0", 1, Pose(10.0, 10.0)))
    camera = it.camera(hall)
    at = camera.to_cell(*FRAME.to_pixel(10.0, 10.0))
    assert pick(hall, camera, *at) is hall.robots[0]
    assert pick(scene(), camera, *at) == VERTICES[0]
    assert pick(scene(), camera, *camera.to_cell(*FRAME.to_pixel(30.0, 10.0))) == VERTICES[1]
    assert pick(scene(), camera, 0, 0) is None
    assert pointed(hall, camera, (10.0, 10.0)) == "1" and pointed(hall, camera, None) is None
