"""The whole picture of a small floor, in every mode, and what each layer promises.

The golden pictures are written anew with FLEET_TUI_REGENERATE=1; look at them before committing.
"""

import math
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import WALLS, StyleRole
from tests.support.drawn_hall import EDGES, FIT, SCENE, VERTICES, drawn

GOLDEN = Path(__file__).parent / "golden"


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
    """Which cells have the roles of ways and trails: a wall under a way has the way's."""
    marks = {
        StyleRole.MISSION: "*",
        StyleRole.MISSION_THROUGH: "*",
        StyleRole.MISSION_NEXT_THROUGH: ":",
        StyleRole.MISSION_NEXT: ":",
        StyleRole.TRAIL: ",",
        StyleRole.TRAIL_OLD: "'",
    }
    return "\n".join("".join(marks.get(StyleRole(role), "-") for role in row) for row in cells.roles.tolist())


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
    assert "→1" in drawn(Scene("f", frame, robots=(robot,))).text()


def test_states_are_words_and_glyphs_not_only_colours() -> None:
    text = drawn().text()
    for part in ("4○", "2!", "3‖", "5≈", "Base", "Consumidores", "↕", "⌂"):
        assert part in text


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
    walls = np.isin(without.roles, WALLS)
    assert np.array_equal(without.codes[walls], with_edges.codes[walls])
    assert (with_edges.roles == StyleRole.EDGE).sum() > 40


def test_a_long_edge_far_outside_costs_no_more_than_its_visible_part() -> None:
    scene = replace(SCENE, edges=((-1e7, 3.0, 1e7, 3.0),))
    y = FIT.to_cell(*SCENE.frame.to_pixel(6, 3.0))[1]
    assert (backdrop(scene, FIT, MapOptions(edges=True)).roles[y] == StyleRole.EDGE).sum() > 40


def test_of_robots_that_keep_apart_each_has_its_number() -> None:
    apart = [Pose(1.0 + n % 10 * 1.1, 0.5 + n // 10 * 0.7, n) for n in range(100)]
    robots = tuple(SceneRobot(f"r{n}", n + 1, pose) for n, pose in enumerate(apart))
    cells = drawn(replace(SCENE, vertices=(), robots=robots), Camera.fit((240, 152), 120, 40))
    tags = np.where(np.isin(cells.roles, (StyleRole.ROBOT, StyleRole.ROBOT_SELECTED)), cells.codes, ord(" "))
    numbers = "".join(map(chr, tags.ravel())).translate({ord(arrow): " " for arrow in "→↗↑↖←↙↓↘"}).split()
    assert sorted(numbers) == sorted(map(str, range(1, 101)))


def test_where_the_whole_tag_finds_no_room_the_number_alone_stands() -> None:
    """In a view of 2 x 1 cells there is room for the number, not for `7○`."""
    robot = SceneRobot("r", 7, Pose(6.0, 3.8), online=False, age=41.0)
    scene = replace(SCENE, vertices=(), robots=(robot,), target_vertices=())
    assert drawn(scene, Camera.fit((240, 152), 2, 1)).text() == "→7"
