"""Missions, one-way edges and trails on the picture: what they cover, and what they never do."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.geometry import Line, MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import WALLS, StyleRole

FRAME = MapFrame(0.05, 400, 200)
CAMERA = Camera.fit((400, 200), 80, 22)
THROUGH = (StyleRole.MISSION_THROUGH, StyleRole.MISSION_NEXT_THROUGH)
LINE = (StyleRole.MISSION, StyleRole.MISSION_THROUGH)


def hall() -> Scene:
    classes = np.full((200, 400), FREE, np.uint8)
    classes[0] = classes[-1] = classes[:, 0] = classes[:, -1] = OCCUPIED
    classes[40:, 200] = OCCUPIED
    return Scene("f", FRAME, build_grid(FRAME, classes))


SCENE = hall()
ACROSS: tuple[Line, ...] = ((2.0, 5.0, 18.0, 5.0),)


def drawn(scene: Scene, look: MapOptions | None = None, camera: Camera = CAMERA) -> Cells:
    look = look or MapOptions()
    return picture(backdrop(scene, camera, look), scene, camera, look)


def dots(cells: Cells, y: int) -> int:
    """The number of dots of a row that are set in braille."""
    codes = [int(code) - 0x2800 for code in cells.codes[y]]
    return sum(code.bit_count() for code in codes if 0 < code < 256)


def test_current_next_and_edge_are_three_kinds_of_line_without_colour_too() -> None:
    y = CAMERA.to_cell(*FRAME.to_pixel(5.0, 5.0))[1]
    empty = dots(drawn(SCENE), y)
    edge = dots(drawn(replace(SCENE, edges=ACROSS), MapOptions(edges=True)), y) - empty
    following = dots(drawn(replace(SCENE, mission=Mission((), ACROSS))), y) - empty
    current = dots(drawn(replace(SCENE, mission=Mission(ACROSS))), y) - empty
    assert following < 0.7 * edge
    assert current > 1.5 * edge
    rows = [
        drawn(scene, MapOptions(Drawing.ASCII, edges=True)).text().split("\n")[y]
        for scene in (
            replace(SCENE, edges=ACROSS),
            replace(SCENE, mission=Mission(ACROSS)),
            replace(SCENE, mission=Mission((), ACROSS)),
        )
    ]
    assert all(row.count(mark) > 30 for row, mark in zip(rows[:2], "+*", strict=True))
    assert rows[2].count(":") > 15


lines = st.tuples(st.floats(-5, 25), st.floats(-5, 15), st.floats(-5, 25), st.floats(-5, 15))


@settings(deadline=None)
@given(
    st.lists(lines, max_size=6), st.lists(lines, max_size=6), st.floats(0.3, 8.0), st.sampled_from(Drawing)
)
def test_no_mission_takes_a_wall_away(
    current: list[Line], following: list[Line], zoom: float, drawing: Drawing
) -> None:
    camera, look = CAMERA.zoomed(zoom), MapOptions(drawing)
    robot = SceneRobot("r", 1, Pose(-9.0, -9.0), selected=True)
    mission = Mission(tuple(current), tuple(following), (8.0, 8.0, 5.0, 5.0))
    before = drawn(SCENE, look, camera)
    after = drawn(replace(SCENE, mission=mission, robots=(robot,)), look, camera)
    walls = np.isin(before.roles, WALLS)
    assert np.isin(after.roles[walls], WALLS + THROUGH).all()
    same = np.isin(after.roles, WALLS)
    assert (after.codes[same] == before.codes[same]).all()


@settings(deadline=None)
@given(lines, lines, st.floats(0.3, 8.0), st.sampled_from(Drawing))
def test_the_current_way_is_one_line_through_walls_and_over_the_next_ways(
    current: Line, following: Line, zoom: float, drawing: Drawing
) -> None:
    camera = CAMERA.zoomed(zoom)
    cells = drawn(
        replace(SCENE, mission=Mission((current,), (following, current))), MapOptions(drawing), camera
    )
    x, y, to_x, to_y = current
    for share in np.linspace(0.0, 1.0, 400):
        column, row = FRAME.to_pixel(x + (to_x - x) * share, y + (to_y - y) * share)
        half = camera.scale / 2
        around = {camera.to_cell(column + dx, row + dy) for dx in (-half, half) for dy in (-half, half)}
        # A point half a dot inside its cell: one at the rim may have its dot in the cell beside it.
        if len(around) == 1 and camera.shows(*(at := around.pop())):
            assert cells.roles[at[1], at[0]] in LINE
    line = np.isin(cells.roles, LINE)
    marks = {chr(code) for code in cells.codes[line]}
    if drawing is Drawing.ASCII:
        assert marks <= {"*", "#"}
    elif drawing is Drawing.HALF_BLOCK:
        assert all(0x2800 < ord(mark) < 0x2900 for mark in marks)


def test_a_way_through_a_wall_goes_on_in_it() -> None:
    y = CAMERA.to_cell(*FRAME.to_pixel(5.0, 5.0))[1]
    left, right = (CAMERA.to_cell(*FRAME.to_pixel(x, 5.0))[0] for x in (2.0, 18.0))
    for drawing in Drawing:
        roles = drawn(replace(SCENE, mission=Mission(ACROSS)), MapOptions(drawing)).roles[y, left : right + 1]
        assert set(roles.tolist()) == set(LINE), drawing


def test_vertices_labels_and_robots_lie_above_the_mission() -> None:
    vertices = (SceneVertex("1", 2.0, 5.0, label="Base"), SceneVertex("2", 18.0, 5.0, label="Store"))
    robot = SceneRobot("r", 1, Pose(6.0, 5.0), selected=True)
    scene = replace(
        SCENE, vertices=vertices, robots=(robot,), mission=Mission((), (), ACROSS[0]), edges=ACROSS
    )
    cells = drawn(scene, MapOptions(edges=True))
    for part in ("Base", "Store", "→1", "o"):
        assert part in cells.text()
    x, y = CAMERA.to_cell(*FRAME.to_pixel(6.0, 5.0))
    assert StyleRole.MISSION not in cells.roles[y, :x]
    assert StyleRole.MISSION in cells.roles[y, x:]


def test_a_plain_vertex_on_the_current_way_is_part_of_the_line() -> None:
    scene = replace(SCENE, vertices=(SceneVertex("1", 6.0, 5.0),))
    x, y = CAMERA.to_cell(*FRAME.to_pixel(6.0, 5.0))
    for drawing, alone, on_way in ((Drawing.BRAILLE, "·", "•"), (Drawing.ASCII, "'", "*")):
        cells = drawn(scene, MapOptions(drawing))
        assert (chr(cells.codes[y, x]), cells.roles[y, x]) == (alone, StyleRole.VERTEX)
        cells = drawn(replace(scene, mission=Mission(ACROSS)), MapOptions(drawing))
        assert (chr(cells.codes[y, x]), cells.roles[y, x]) == (on_way, StyleRole.MISSION)


def test_the_way_to_the_entry_moves_with_the_robot_over_the_same_backdrop() -> None:
    scene = replace(SCENE, mission=Mission(ACROSS, (), (2.0, 9.5, 2.0, 5.0)))
    behind = backdrop(scene, CAMERA, MapOptions())
    x, y = CAMERA.to_cell(*FRAME.to_pixel(2.0, 7.0))
    for top, there in ((9.0, True), (6.0, False)):
        robot = SceneRobot("r", 1, Pose(2.0, top), selected=True)
        cells = picture(behind, replace(scene, robots=(robot,)), CAMERA, MapOptions())
        assert (cells.roles[y, x] == StyleRole.MISSION) == there
    assert behind.roles[y, x] != StyleRole.MISSION


@pytest.mark.parametrize(
    ("line", "arrow", "plain"),
    [
        ((2.0, 5.0, 8.0, 5.0), "▸", ">"),
        ((8.0, 5.0, 2.0, 5.0), "◂", "<"),
        ((5.0, 2.0, 5.0, 8.0), "▴", "^"),
        ((5.0, 8.0, 5.0, 2.0), "▾", "v"),
    ],
)
def test_a_one_way_edge_has_an_arrow_in_its_middle(line: Line, arrow: str, plain: str) -> None:
    scene = replace(SCENE, edges=(line,), one_way=(line,))
    x, y = CAMERA.to_cell(*FRAME.to_pixel((line[0] + line[2]) / 2, (line[1] + line[3]) / 2))
    for drawing, mark in ((Drawing.BRAILLE, arrow), (Drawing.HALF_BLOCK, arrow), (Drawing.ASCII, plain)):
        row = drawn(scene, MapOptions(drawing, edges=True)).text().split("\n")[y]
        assert mark in row[x - 1 : x + 2]
    assert arrow not in drawn(scene).text()
    assert arrow not in drawn(replace(scene, one_way=()), MapOptions(edges=True)).text()


def test_an_edge_seen_in_part_has_its_arrow_where_it_is_seen_and_a_short_one_none() -> None:
    long, short = (-500.0, 9.0, 50.0, 9.0), (5.0, 2.0, 5.2, 2.0)
    scene = replace(SCENE, edges=(long, short), one_way=(long, short))
    assert drawn(scene, MapOptions(edges=True)).text().count("▸") == 1


def trail(*points: tuple[float, float, float]) -> np.ndarray:
    return np.array(points, np.float64)


def test_trails_pale_and_thin_out_with_age_and_hide_nothing() -> None:
    young = trail(*((2.0 + n / 4, 3.0, 5.0) for n in range(30)))
    old = trail(*((2.0 + n / 4, 7.0, 50.0) for n in range(30)))
    walls = trail(*((n / 10, 0.02, 1.0) for n in range(200)))
    before, after = drawn(SCENE), drawn(replace(SCENE, trail=np.concatenate((young, old, walls))))
    young_row, old_row = (CAMERA.to_cell(*FRAME.to_pixel(2.0, y))[1] for y in (3.0, 7.0))
    assert StyleRole.TRAIL in after.roles[young_row]
    assert StyleRole.TRAIL_OLD in after.roles[old_row]
    assert dots(after, old_row) < dots(after, young_row)
    hidden = np.isin(before.roles, WALLS)
    assert np.array_equal(before.codes[hidden], after.codes[hidden])
    assert np.array_equal(before.roles[hidden], after.roles[hidden])


@given(st.floats(2.0, 17.0), st.floats(-0.3, 0.3))
def test_the_line_ahead_does_not_dance_with_the_pose(x: float, noise: float) -> None:
    scene = replace(SCENE, mission=Mission((), (), (2.0, 2.0, 18.0, 7.3)))
    on_it = Pose(x, 2.0 + (x - 2.0) * 5.3 / 16)
    rows = []
    for pose in (on_it, Pose(on_it.x - noise * 0.33, on_it.y + noise)):
        robot = SceneRobot("r", 1, pose, selected=True)
        codes = drawn(replace(scene, robots=(robot,))).codes
        rows.append(codes[:, CAMERA.to_cell(*FRAME.to_pixel(x, 5.0))[0] + 4 :])
    assert np.array_equal(rows[0], rows[1])


def test_a_robot_beside_its_edge_is_led_back_to_it() -> None:
    scene = replace(SCENE, mission=Mission((), (), (2.0, 2.0, 8.0, 2.0)))
    cells = drawn(replace(scene, robots=(SceneRobot("r", 1, Pose(8.0, 8.0), selected=True),)))
    x, y = CAMERA.to_cell(*FRAME.to_pixel(8.0, 5.0))
    assert cells.roles[y, x] == StyleRole.MISSION


@pytest.mark.parametrize("far", [1e300, -1e300, float("inf"), float("nan")])
def test_a_way_to_nowhere_breaks_nothing(far: float) -> None:
    scene = replace(SCENE, mission=Mission(((2.0, 2.0, far, 5.0),), (), (2.0, 2.0, 5.0, far)))
    robot = SceneRobot("r", 1, Pose(2.0, 2.0), selected=True)
    assert "→1" in drawn(replace(scene, robots=(robot,))).text()


@given(st.floats(1.0, 9.0), st.floats(2.0, 18.0))
def test_a_straight_way_takes_one_line_of_cells(y: float, x: float) -> None:
    across = drawn(replace(SCENE, mission=Mission(((2.0, y, 18.0, y),))))
    assert len(np.unique(np.nonzero(np.isin(across.roles, LINE))[0])) == 1
    down = drawn(replace(SCENE, mission=Mission(((x, 1.0, x, 9.0),))))
    assert len(np.unique(np.nonzero(np.isin(down.roles, LINE))[1])) == 1


@pytest.mark.parametrize("drawing", [Drawing.BRAILLE, Drawing.ASCII])
def test_a_blocked_edge_is_a_line_with_a_sign_over_the_way_and_through_no_wall(drawing: Drawing) -> None:
    scene = replace(SCENE, mission=Mission(ACROSS), blocked=((2.0, 5.0, 18.0, 5.0),))
    cells, look = drawn(scene, MapOptions(drawing)), MapOptions(drawing)
    (x, y), walls = CAMERA.to_cell(*FRAME.to_pixel(10.0, 5.0)), drawn(SCENE, look).roles
    assert chr(cells.codes[y, x]) == "!" and cells.roles[y, x] == StyleRole.ALARM
    row = cells.roles[y, CAMERA.to_cell(*FRAME.to_pixel(3.0, 5.0))[0] : x - 1]
    assert (row == StyleRole.ALARM).all(), "the edge, not the way over it"
    elsewhere = np.isin(walls, WALLS)
    elsewhere[y, x] = False
    assert (cells.roles[elsewhere] != StyleRole.ALARM).all()


def test_the_sign_of_a_closed_or_blocked_edge_is_in_no_label() -> None:
    vertex = SceneVertex("1", 9.6, 5.0, label="Elevator")
    for scene in (replace(SCENE, blocked=ACROSS), replace(SCENE, closed=ACROSS)):
        assert "Elevator" in drawn(replace(scene, vertices=(vertex,))).text()


@pytest.mark.parametrize("drawing", [Drawing.BRAILLE, Drawing.ASCII])
def test_the_ways_of_robots_that_wait_for_each_other_are_dashed_and_red(drawing: Drawing) -> None:
    way, look = ((2.0, 5.0, 18.0, 5.0),), MapOptions(drawing)
    whole = drawn(replace(SCENE, blocked=way), look).roles == StyleRole.ALARM
    dashes = drawn(replace(SCENE, deadlocked=way), look).roles == StyleRole.ALARM
    assert 0 < dashes.sum() <= whole.sum() and not (dashes & ~whole).any()
