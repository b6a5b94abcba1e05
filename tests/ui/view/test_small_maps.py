"""Small maps of the other floors: each with its robots, as large as the space allows."""

from dataclasses import replace

from fleet_tui.model.desk.events import AlarmAcknowledged
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.small_maps import SmallMaps, grid_of, other_floors
from tests.support.fleets import F0, R0, T0, battery, fleet, pose, reduced, tick
from tests.support.map_pane import SCENE

R1, F1 = "robot_1", "floor_1"
ALONE = replace(SCENE, robots=SCENE.robots[:1], elsewhere="! robot_9 on floor_9", note="no map yet")


def shown(width: int, height: int, *scenes: Scene) -> list[str]:
    maps = SmallMaps()
    maps.show(scenes, MapOptions())
    cells = maps.cells(width, height)
    return [] if cells is None else cells.text().split("\n")


def test_the_other_floors_have_their_own_robots() -> None:
    state = reduced(fleet(2, 2), pose(T0), pose(T0, robot=R1, frame=F1))
    (other,) = other_floors(state, Selection(R0, F0))
    assert other.floor == F1 and [robot.name for robot in other.robots] == [R1]
    (other,) = other_floors(state, Selection(R0, F1))
    assert other.floor == F0 and [robot.name for robot in other.robots] == [R0]


def test_an_acknowledged_alarm_is_red_on_no_small_map() -> None:
    places = (pose(T0), pose(T0, robot=R1, frame=F1))
    state = reduced(fleet(2, 2), *places, battery(T0, 5.0, robot=R1), tick(T0))
    for now, is_red in ((state, True), (reduced(state, AlarmAcknowledged()), False)):
        maps = SmallMaps()
        maps.show(other_floors(now, Selection(R0, F0)), MapOptions())
        cells = maps.cells(60, 12)
        assert cells is not None and "1!" in cells.text()
        assert (StyleRole.ROBOT_ALARM in cells.roles) == is_red


def test_a_caption_names_the_floor_and_its_robots_and_nothing_of_elsewhere() -> None:
    rows = shown(60, 12, ALONE)
    assert rows[0].startswith("─ floor_0 ── robot_0 ── ")
    assert "robot_9" not in rows[0] and "no map" not in rows[0]
    assert all(row[-1] == " " for row in rows), "a name at the screen's edge would seem to be cut"
    assert "→1" in "\n".join(rows) and len(rows) == 12 and {len(row) for row in rows} == {60}
    assert shown(60, 12, replace(SCENE, robots=()))[0].startswith("─ floor_0 ── no robot ─")
    assert shown(24, 9, SCENE)[0].startswith("─ floor_0 ── 2 robots ─")


def test_a_floor_without_a_map_is_drawn_by_its_edges() -> None:
    bare = replace(SCENE, grid=None, edges=((2.0, 5.0, 18.0, 5.0),), robots=())
    assert sum(any("⠀" <= cell <= "⣿" for cell in row) for row in shown(60, 12, bare)) == 1


def test_several_floors_share_the_space_and_a_click_finds_each() -> None:
    scenes = [replace(SCENE, floor=f"floor_{n}") for n in range(4)]
    maps = SmallMaps()
    maps.show(scenes, MapOptions())
    cells = maps.cells(80, 28)
    assert cells is not None
    rows = cells.text().split("\n")
    assert "floor_0" in rows[0] and "floor_1" in rows[0][40:] and "floor_2" in rows[14]
    corners = ((0, 0), (79, 0), (0, 27), (79, 27))
    assert [maps.floor_at(x, y, 80, 28) for x, y in corners] == [scene.floor for scene in scenes]
    maps.show(scenes[:3], MapOptions())
    assert maps.floor_at(79, 27, 80, 28) == ""


def test_floors_are_as_large_as_possible_and_those_without_space_are_left_out() -> None:
    assert grid_of(1, 80, 28) == (1, 1)
    assert grid_of(2, 60, 28) == (1, 2) and grid_of(2, 80, 14) == (2, 1)
    columns, rows = grid_of(9, 80, 14)
    assert columns * rows == 2


def test_without_floors_or_space_there_is_nothing() -> None:
    assert shown(60, 12) == [] and shown(0, 12, SCENE) == []
