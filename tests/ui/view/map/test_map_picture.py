"""The picture of a floor and what is kept of it from one moment to the next."""

from dataclasses import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.ui.view.map.map_picture import CAPTION_ROWS, MapPicture
from fleet_tui.ui.view.map.modes.mode import CursorMode
from fleet_tui.ui.view.map.scene import Mission
from fleet_tui.ui.view.roles import StyleRole
from tests.support.map_pane import SCENE, moved


def shown() -> MapPicture:
    picture = MapPicture()
    picture.show(SCENE)
    assert picture.cells(100, 30, True) is not None
    return picture


def caption(picture: MapPicture) -> str:
    cells = picture.cells(100, 30, True)
    assert cells is not None
    return "".join(map(chr, cells.codes[0]))


def test_without_a_scene_or_space_there_is_no_picture() -> None:
    assert MapPicture().cells(100, 30, True) is None and MapPicture().pick(5, 5) is None
    picture = shown()
    assert picture.cells(0, 30, True) is None and picture.cells(100, CAPTION_ROWS, True) is None


def test_a_cursor_on_a_place_says_its_name() -> None:
    picture = shown()
    place = SCENE.vertices[0]
    picture.mode = CursorMode((place.x, place.y))
    assert f"{place.label}, x {place.x:.1f} y {place.y:.1f} m" in caption(picture)
    picture.mode = CursorMode((place.x + 3.0, place.y + 3.0))
    assert place.label not in caption(picture) and f"x {place.x + 3:.1f}" in caption(picture)


def test_the_backdrop_is_kept_until_something_in_it_changes() -> None:
    picture = shown()
    kept = picture.backdrop
    for scene in (moved(SCENE, 6.0, 6.0), replace(SCENE, mission=Mission(edge=(2.0, 2.0, 18.0, 8.0)))):
        picture.show(scene)
        picture.cells(100, 30, False)
        assert picture.backdrop is kept
    for scene in (replace(SCENE, target_vertices=("1",)), replace(SCENE, vertices=SCENE.vertices[:1])):
        picture.show(scene)
        picture.cells(100, 30, True)
        assert picture.backdrop is not kept
        kept = picture.backdrop


def test_what_lies_under_a_cell_is_picked_below_the_caption() -> None:
    picture = shown()
    robot = SCENE.robots[0]
    camera = picture.viewport.camera(SCENE)
    x, y = camera.to_cell(*SCENE.frame.to_pixel(robot.pose.x, robot.pose.y))
    assert picture.pick(x, y + CAPTION_ROWS) == robot
    assert picture.pick(x, 0) is None


def test_trails_are_those_of_the_time_that_is_shown() -> None:
    picture = shown()
    picture.options = replace(picture.options, trails=True)
    for second in range(10):
        picture.show(replace(moved(SCENE, 2.0 + second, 5.0), at=float(second)))
    assert picture.scene is not None and len(picture.trails.of(picture.scene))
    picture.clear_trails()
    assert not len(picture.trails.of(picture.scene))
    assert picture.scene.robots[0].pose == Pose(11.0, 5.0)


def test_a_number_keeps_its_side_when_the_view_moves() -> None:
    robot = SCENE.robots[1]
    close = robot._replace(number=1, pose=Pose(robot.pose.x - 0.4, robot.pose.y))
    picture = MapPicture()
    for scene in (replace(SCENE, robots=(close, robot)), SCENE):
        picture.show(scene)
        cells = picture.cells(100, 30, True)
        assert cells is not None and "→2" in cells.text()
        picture.viewport.pan(SCENE, 3, 1)
    cells = picture.cells(100, 30, True)
    assert cells is not None and "→2" in cells.text()


def test_the_caption_says_that_the_selected_robot_is_out_of_view() -> None:
    picture = shown()
    assert "out of view" not in caption(picture)
    picture.viewport.pan(SCENE, 200, 0)
    assert "robot_0 is out of view" in caption(picture)


def test_a_robot_with_an_alarm_that_is_out_of_view_is_named_as_such() -> None:
    picture = shown()
    assert picture.scene is not None
    picture.show(replace(picture.scene, robots=(picture.scene.robots[0]._replace(alarmed=True),)))
    assert "!" not in caption(picture)
    picture.viewport.pan(SCENE, 200, 0)
    assert "! robot_0 out of view" in caption(picture) and "is out of view" not in caption(picture)


def test_the_cell_of_the_map_under_the_cursor_is_counted_from_the_upper_left() -> None:
    picture = shown()
    assert "cell" not in caption(picture)
    picture.mode = CursorMode((2.01, 9.99))
    frame = SCENE.frame
    column, row = int(2.01 / frame.resolution), frame.height - int(9.99 / frame.resolution) - 1
    assert (SCENE.grid is not None) == (f"cell {column}, {row}" in caption(picture))


def test_without_a_map_the_edges_are_shown_until_they_are_switched_off() -> None:
    def edges(picture: MapPicture, has_map: bool) -> bool:
        picture.show(replace(SCENE, grid=SCENE.grid if has_map else None, edges=((2.0, 5.0, 18.0, 5.0),)))
        cells = picture.cells(100, 30, False)
        assert cells is not None
        return bool((cells.roles == StyleRole.EDGE).any())

    picture = MapPicture()
    assert edges(picture, has_map=False) and not edges(picture, has_map=True)
    picture.options = replace(picture.options, edges=False)
    assert not edges(picture, has_map=False)
    picture.options = replace(picture.options, edges=True)
    assert edges(picture, has_map=True)


def test_who_is_selected_and_out_of_view_is_a_problem_only_off_the_map() -> None:
    picture = MapPicture()
    for is_off in (False, True):
        lost = SCENE.robots[0]._replace(selected=True, misplaced=is_off, pose=Pose(-900.0, 5.0))
        picture.show(replace(SCENE, robots=(lost,)))
        cells = picture.cells(100, 30, False)
        assert cells is not None and "is out of view" in caption(picture)
        assert bool((cells.roles[0] == StyleRole.WARN).any()) is is_off
        assert ("⇠" in cells.text()) is is_off
