"""The whole picture of a small floor, in every mode, and what each layer promises.

The golden pictures are written anew with FLEET_TUI_REGENERATE=1; look at them before committing.
"""

import math
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.picture import backdrop, picture
from fleet_tui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.view.roles import StyleRole

GOLDEN = Path(__file__).parent / "golden"
WIDTH, HEIGHT = 64, 20


def hall() -> OccupancyGrid:
    """12 x 7.6 m: a hall with a dividing wall, two racks and unknown ground at the right."""
    classes = np.full((152, 240), FREE, np.uint8)
    classes[:, 210:] = UNKNOWN
    classes[4:-4, 4] = classes[4:-4, 209] = OCCUPIED
    classes[4, 4:210] = classes[-5, 4:210] = OCCUPIED
    classes[4:90, 90] = OCCUPIED
    classes[30:46, 120:180] = classes[80:96, 120:180] = OCCUPIED
    return build_grid(MapFrame(0.05, 240, 152), classes)


VERTICES = (
    SceneVertex("1", 1.5, 6.2, label="Base"),
    SceneVertex("2", 9.5, 2.2, label="Consumidores"),
    SceneVertex("3", 1.5, 1.2, Role.DOCKING, "Dock"),
    SceneVertex("4", 7.2, 4.6, Role.ELEVATOR, "仓库"),
    SceneVertex("5", 3.0, 2.2),
    SceneVertex("6", 5.2, 2.2),
)
EDGES = ((1.5, 6.2, 3.0, 2.2), (1.5, 1.2, 3.0, 2.2), (3.0, 2.2, 5.2, 2.2), (5.2, 2.2, 9.5, 2.2))
ROBOTS = (
    SceneRobot("robot_0", 1, Pose(2.47, 4.04, -1.2), mark="1", cargo=True, selected=True),
    SceneRobot("robot_1", 2, Pose(6.0, 2.3, math.pi), mark="2", obstacle=True),
    SceneRobot("robot_2", 3, Pose(6.1, 2.3, 0.8), mark="3", paused=True, cargo=True),
    SceneRobot("robot_3", 4, Pose(7.23, 6.62, math.pi / 2), mark="4", online=False, age=41.2),
    SceneRobot("robot_4", 5, Pose(3.53, 5.83, 2.3), mark="5", other_map=True),
)
HALL = hall()
SCENE = Scene("floor_0", HALL.frame, HALL, VERTICES, EDGES, ROBOTS, ("1", "2"))
FIT = Camera.fit((240, 152), WIDTH, HEIGHT)


def drawn(scene: Scene = SCENE, camera: Camera = FIT, look: MapOptions | None = None) -> Cells:
    look = look or MapOptions()
    return picture(backdrop(scene, camera, look), scene, camera, look)


def is_golden(text: str, name: str) -> None:
    text, path = text + "\n", GOLDEN / f"{name}.txt"
    if os.environ.get("FLEET_TUI_REGENERATE"):
        path.write_text(text, encoding="utf-8")
    assert text == path.read_text(encoding="utf-8")


@pytest.mark.parametrize("drawing", list(Drawing))
@pytest.mark.parametrize("zoomed", [False, True])
def test_golden(drawing: Drawing, zoomed: bool) -> None:
    camera = FIT.zoomed(2, SCENE.frame.to_pixel(6.0, 2.3)) if zoomed else FIT
    cells = drawn(camera=camera, look=MapOptions(drawing, edges=zoomed))
    is_golden(cells.text(), f"{drawing.value}{'_zoomed_edges' if zoomed else ''}")


@pytest.mark.parametrize("drawing", list(Drawing))
def test_golden_mission_and_trails(drawing: Drawing) -> None:
    """The current way goes through the dividing wall, the next one through a rack; one trail is old."""
    along = np.arange(0.0, 3.0, 0.12)
    fresh = np.stack((2.6 + along * 0.8, 4.2 + along * 0.6, along), axis=1)
    old = np.stack((8.0 + along * 0.2, 1.0 + along * 0.6, 40.0 + along), axis=1)
    current = ((3.0, 2.2, 3.0, 1.2), (3.0, 1.2, 9.5, 5.2))
    following = ((9.5, 5.2, 9.5, 2.2), (9.5, 2.2, 5.2, 2.2))
    way = Mission(current, following, (1.5, 6.2, 3.0, 2.2))
    scene = replace(SCENE, mission=way, trail=np.concatenate((fresh, old)))
    cells = drawn(scene, look=MapOptions(drawing, trails=True))
    is_golden(f"{cells.text()}\n\n{_ways(cells)}", f"{drawing.value}_mission_trails")


def _ways(cells: Cells) -> str:
    """Which cells have the inks of ways and trails: a wall under a way has the way's."""
    marks = {
        StyleRole.MISSION: "*",
        StyleRole.MISSION_NEXT: ":",
        StyleRole.TRAIL: ",",
        StyleRole.TRAIL_OLD: "'",
    }
    return "\n".join("".join(marks.get(StyleRole(ink), "-") for ink in row) for row in cells.inks.tolist())


def test_ascii_is_ascii_whatever_the_labels_say() -> None:
    assert drawn(look=MapOptions(Drawing.ASCII, edges=True)).text().isascii()


@pytest.mark.parametrize("eighth", range(8))
def test_the_arrow_points_where_the_robot_heads(eighth: int) -> None:
    for cargo, arrows in ((False, "→↗↑↖←↙↓↘"), (True, "▶◥▲◤◀◣▼◢")):
        robot = SceneRobot("r", 1, Pose(6.0, 2.3, eighth * math.pi / 4 + 0.3), cargo=cargo)
        scene = replace(SCENE, vertices=(), robots=(robot,))
        x, y = FIT.to_cell(*scene.frame.to_pixel(6.0, 2.3))
        assert drawn(scene).text().split("\n")[y][x] == arrows[eighth]


def test_a_turned_map_turns_the_arrows() -> None:
    frame = MapFrame(0.05, 240, 152, Pose(0, 0, math.pi / 2))
    robot = SceneRobot("r", 1, Pose(-2, 3, math.pi / 2))
    assert "1→" in drawn(Scene("f", frame, robots=(robot,))).text()


def test_states_are_words_and_glyphs_not_only_colours() -> None:
    text = drawn().text()
    for part in ("41 s", "2!", "3‖", "5≈", "Base", "Consumidores", "↕", "⌂"):
        assert part in text


def test_the_selected_robot_lies_on_top() -> None:
    pose = Pose(6.0, 2.3, 0.0)
    robots = tuple(SceneRobot(f"r{n}", n, structs.replace(pose, yaw=n), selected=n == 2) for n in (1, 2, 3))
    cells = drawn(replace(SCENE, robots=robots))
    x, y = FIT.to_cell(*SCENE.frame.to_pixel(6.0, 2.3))
    assert cells.inks[y, x] == StyleRole.ROBOT_SELECTED
    rows = cells.text().split("\n")
    assert rows[y][x - 1] == "2"


def test_robots_that_are_nowhere_are_not_drawn_and_break_nothing() -> None:
    robots = tuple(
        SceneRobot(f"r{n}", n, Pose(x, 0.0)) for n, x in enumerate((math.nan, math.inf, 1e300, -1e300))
    )
    vertices = (*VERTICES, SceneVertex("9", math.nan, 1.0, label="x"), SceneVertex("10", 1e300, math.inf))
    edges = (
        *EDGES,
        (math.nan, 0.0, 1.0, 1.0),
        (0.0, 0.0, math.inf, 1.0),
        (math.inf, 0.0, math.inf, 2.0),
        (-1e9, 1.0, 1e9, 1.0),
    )
    scene = replace(SCENE, robots=robots, vertices=vertices, edges=edges)
    assert "Base" in drawn(scene, look=MapOptions(edges=True)).text()


def test_edges_hide_no_wall() -> None:
    without, with_edges = (backdrop(SCENE, FIT, MapOptions(edges=on, labels=False)) for on in (False, True))
    walls = (without.inks == StyleRole.WALL) | (without.inks == StyleRole.WALL_BEYOND)
    assert np.array_equal(without.codes[walls], with_edges.codes[walls])
    assert (with_edges.inks == StyleRole.EDGE).sum() > 40


def test_a_long_edge_far_outside_costs_no_more_than_its_visible_part() -> None:
    scene = replace(SCENE, edges=((-1e7, 3.0, 1e7, 3.0),))
    y = FIT.to_cell(*SCENE.frame.to_pixel(6, 3.0))[1]
    assert (backdrop(scene, FIT, MapOptions(edges=True)).inks[y] == StyleRole.EDGE).sum() > 40


labels = st.text(st.sampled_from("abcXYZ 仓é\x1b\u202e\n"), min_size=1, max_size=14)
crowded = st.integers(0, 8).map(lambda step: 4.0 + step * 0.2)
places = st.lists(st.tuples(crowded, crowded, labels), max_size=25)


@settings(deadline=None)
@given(places, st.floats(0.5, 4))
def test_labels_are_whole_or_absent_and_never_overlap(
    at: list[tuple[float, float, str]], zoom: float
) -> None:
    vertices = tuple(SceneVertex(str(n), x, y, label=label) for n, (x, y, label) in enumerate(at))
    scene = replace(SCENE, vertices=vertices, robots=(), target_vertices=("0",))
    cells = backdrop(scene, FIT.zoomed(zoom), MapOptions())
    shown = {run for runs in cells.all_runs() for run in runs}
    wanted = [vertex.label for vertex in vertices]
    for text, ink in shown:
        assert "\x1b" not in text
        assert "\u202e" not in text
        if ink in (StyleRole.LABEL, StyleRole.TARGET) and text not in ("o", "·"):
            assert text in {_safe(label) for label in wanted}


def _safe(label: str) -> str:
    return label.replace("\x1b", "␛").replace("\u202e", "\ufffd").replace("\n", "␊")


def test_the_missions_ends_get_their_labels_first() -> None:
    crowd = tuple(SceneVertex(str(n), 6.0 + n * 0.01, 3.0, label=f"place {n}") for n in range(30))
    cells = backdrop(replace(SCENE, vertices=crowd, target_vertices=("29",)), FIT, MapOptions())
    assert "place 29" in cells.text()
    assert "place 28" not in cells.text()


def test_the_cursor_marks_its_cell() -> None:
    look = MapOptions(cursor=(6.0, 3.0))
    x, y = FIT.to_cell(*SCENE.frame.to_pixel(6.0, 3.0))
    assert drawn(look=look).inks[y, x] == StyleRole.CURSOR


def test_the_label_under_the_cursor_goes_before_the_others_but_not_before_the_missions() -> None:
    crowd = tuple(SceneVertex(str(n), 6.0 + n * 0.01, 3.0, label=f"place {n}") for n in range(30))
    scene = replace(SCENE, vertices=crowd, target_vertices=("29",))
    text = backdrop(scene, FIT, MapOptions(pointed="17")).text()
    assert "place 29" in text
    assert "place 17" in text
    assert "place 17" not in backdrop(scene, FIT, MapOptions()).text()


def test_of_robots_that_keep_apart_each_has_its_number() -> None:
    apart = [Pose(1.0 + n % 10 * 1.1, 0.5 + n // 10 * 0.7, n) for n in range(100)]
    robots = tuple(SceneRobot(f"r{n}", n + 1, pose) for n, pose in enumerate(apart))
    cells = drawn(replace(SCENE, vertices=(), robots=robots), Camera.fit((240, 152), 120, 40))
    tags = np.where(np.isin(cells.inks, (StyleRole.ROBOT, StyleRole.ROBOT_SELECTED)), cells.codes, ord(" "))
    numbers = "".join(map(chr, tags.ravel())).translate({ord(arrow): " " for arrow in "→↗↑↖←↙↓↘"}).split()
    assert sorted(numbers) == sorted(map(str, range(1, 101)))


def test_where_the_whole_tag_finds_no_room_the_number_alone_stands() -> None:
    """In a view of 5 x 1 cells there is room for the number, not for `7 41 s`."""
    robot = SceneRobot("r", 7, Pose(6.0, 3.8), online=False, age=41.0)
    scene = replace(SCENE, vertices=(), robots=(robot,), target_vertices=())
    assert "7→" in drawn(scene, Camera.fit((240, 152), 5, 1)).text()
