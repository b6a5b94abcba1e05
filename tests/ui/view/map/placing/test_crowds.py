"""A crowd: chips that count neighbours, and no state that another one hides."""

import random
import re
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.glyphs import is_special, robot_roles
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.places import seen_robots
from fleet_tui.ui.view.map.placing.crowds import BLOCK, LEAST, clusters, crowd_chips, is_crowd
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.scene import Scene, SceneRobot
from fleet_tui.ui.view.roles import StyleRole

CAMERA = Camera.fit((400, 200), 40, 12)
FRAME = MapFrame(0.05, 400, 200)
NO_STATE: dict[str, Any] = {}
states = st.sampled_from(
    [*[NO_STATE] * 3, {"alarmed": True}, {"online": False, "age": 9.0}, {"obstacle": True}, {"paused": True}]
)
places = st.tuples(st.floats(0.1, 19.9), st.floats(0.1, 9.9))


@st.composite
def crowds(draw: st.DrawFn) -> Scene:
    chosen = draw(st.integers(-1, LEAST))
    robots = tuple(
        SceneRobot(f"r{n}", n, Pose(*draw(places)), selected=n == chosen, **draw(states))
        for n in range(1, LEAST + draw(st.integers(1, 30)))
    )
    return Scene("f", FRAME, robots=robots)


@given(crowds())
def test_every_robot_is_in_one_cluster_near_its_first_one_and_none_hides_a_state(scene: Scene) -> None:
    seen = seen_robots(scene, CAMERA)
    cells, found = {robot.name: at for robot, at in seen}, clusters(seen)
    assert sorted(robot.name for one in found for robot in one.robots) == sorted(cells)
    for (x, y), robots in found:
        assert cells[robots[0].name] == (x, y)
        blocks = {(at_x // BLOCK[0], at_y // BLOCK[1]) for at_x, at_y in (cells[one.name] for one in robots)}
        assert len(blocks) == 1
        assert len({robot_roles(one)[1] if is_special(one) else None for one in robots}) == 1
        assert len(robots) == 1 or not any(one.selected for one in robots)


@given(crowds(), st.booleans())
def test_chips_are_in_the_view_and_cover_nothing_but_their_own(scene: Scene, plain: bool) -> None:
    occupancy, seen = CellOccupancy(CAMERA.width, CAMERA.height), seen_robots(scene, CAMERA)
    drawn = set[tuple[int, int]]()
    for x, y, text, _ in crowd_chips(occupancy, seen, 0.0, plain):
        cells = {(x + n, y) for n in range(len(text))}
        assert cells <= {(n, m) for n in range(CAMERA.width) for m in range(CAMERA.height)}
        assert not cells & drawn
        assert not plain or text.isascii()
        drawn |= cells


def test_neighbours_are_counted_and_the_selected_one_and_an_alarm_stand_out() -> None:
    calm = [SceneRobot(f"r{n}", n, Pose(5.0, 5.0)) for n in range(1, LEAST + 1)]
    assert counts(*calm) == [f"×{LEAST}"]
    assert counts(*calm, drawing=Drawing.ASCII) == [f"x{LEAST}"]
    alarmed = calm[3]._replace(alarmed=True)
    chosen = calm[7]._replace(selected=True)
    shown = text(*calm[:3], alarmed, *calm[4:7], chosen, *calm[8:])
    for chip in ("→8", "→4!", f"×{LEAST - 2}"):
        assert chip in shown
    assert "→4!+1" in text(*calm[:3], alarmed, alarmed._replace(name="other", number=9), *calm[5:])


def test_few_robots_and_a_close_zoom_have_numbers() -> None:
    assert not is_crowd(LEAST - 1, CAMERA) and is_crowd(LEAST, CAMERA)
    calm = [SceneRobot(f"r{n}", n, Pose(5.0 + n / 9, 5.0)) for n in range(1, LEAST + 1)]
    near = CAMERA.zoomed(12.0, FRAME.to_pixel(5.0, 5.0))
    assert "×" not in text(*calm, camera=near) and "→" in text(*calm, camera=near)


def text(*robots: SceneRobot, drawing: Drawing = Drawing.BRAILLE, camera: Camera = CAMERA) -> str:
    scene, look = Scene("f", FRAME, robots=robots), MapOptions(drawing)
    cells = picture(backdrop(scene, camera, look), scene, camera, look)
    assert StyleRole.ROBOT in cells.roles
    return cells.text()


def counts(*robots: SceneRobot, drawing: Drawing = Drawing.BRAILLE) -> list[str]:
    return re.findall(r"[×x]\d+", text(*robots, drawing=drawing))


def test_among_hundreds_the_paused_ones_keep_their_chips() -> None:
    rng = random.Random(3)
    robots = [
        SceneRobot(f"r{n}", n, Pose(rng.uniform(0.1, 19.9), rng.uniform(0.1, 9.9)), paused=n % 12 == 0)
        for n in range(400, 900)
    ]
    groups = clusters(seen_robots(Scene("f", FRAME, robots=tuple(robots)), CAMERA))
    paused = sum(one.robots[0].paused for one in groups)
    assert paused > 20 and text(*robots).count("‖") >= 0.95 * paused
