"""Labels stay where they are; they give way to robots without hopping, and never read as another one."""

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.placing.labels import PASSING, VACANT
from fleet_tui.ui.view.map.robots import Arrangement
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import LABELS, StyleRole

NAME = "Pharmacy"
CAMERA = Camera.fit((400, 200), 120, 40)
CELL = CAMERA.scale * 2 * 0.05
"""Metres."""
QUIET = Scene("f", MapFrame(0.05, 400, 200), vertices=(SceneVertex("1", 10.05, 5.0, label=NAME),))
SCENE = replace(QUIET, target_vertices=("1",))
LOOK = MapOptions()
BEHIND = backdrop(SCENE, CAMERA, LOOK)


def drawn(cells: float, rows: float = 0.0, before: Arrangement | None = None, at: float = 0.0) -> Cells:
    """A robot so many cells right of the vertex and rows below it."""
    pose = Pose(10.05 + cells * CELL, 5.0 - rows * 2 * CELL)
    return picture(BEHIND, replace(SCENE, robots=(SceneRobot("r", 7, pose),), at=at), CAMERA, LOOK, before)


def place(cells: Cells) -> tuple[int, int] | None:
    """The row and the column of the label, if it is there."""
    rows = cells.text().splitlines()
    return next(((y, row.index(NAME)) for y, row in enumerate(rows) if NAME in row), None)


def rest(cells: Cells) -> str:
    """What is seen of the label at its usual place, with spaces for what is not."""
    y, x = place(BEHIND) or (0, 0)
    is_label = np.isin(cells.roles[y, x : x + len(NAME)], LABELS)
    codes = np.where(is_label, cells.codes[y, x : x + len(NAME)], ord(" "))
    return "".join(map(chr, codes))


@given(st.floats(-20, 20), st.floats(-3, 3), st.sampled_from((SCENE, QUIET)))
def test_a_label_is_whole_or_its_start_says_that_it_goes_on(cells: float, rows: float, scene: Scene) -> None:
    before, pose = Arrangement(), Pose(10.05 + cells * CELL, 5.0 - rows * 2 * CELL)
    picture(backdrop(scene, CAMERA, LOOK), scene, CAMERA, LOOK, before)
    robot = SceneRobot("r", 7, pose)
    after = picture(backdrop(scene, CAMERA, LOOK), replace(scene, robots=(robot,)), CAMERA, LOOK, before)
    seen = rest(after)
    row = after.text().splitlines()[(place(BEHIND) or (0, 0))[0]]
    assert "…" not in row or "…" in seen, "no sign without letters"
    start = seen.rstrip()
    assert not start or start == NAME or (len(start) > 2 and start[-1] == "…" and NAME.startswith(start[:-1]))


def test_of_a_label_below_a_robot_that_passes_its_start_is_seen() -> None:
    before = Arrangement()
    texts = [rest(drawn(12 - step, before=before, at=step / 10)) for step in range(12)]
    assert "Phar…   " in texts and all(text.startswith(("P", " " * len(NAME))) for text in texts)


def test_it_is_away_while_a_robot_passes_and_at_its_place_again_then() -> None:
    before = Arrangement()
    places = [place(drawn(10 - step / 2, before=before, at=step / 10)) for step in range(40)]
    usual = place(BEHIND)
    assert places[0] == places[-1] == usual and set(places) == {usual, None}


def test_it_waits_for_a_robot_that_drives_along_it_however_slowly() -> None:
    before = Arrangement()
    places = [place(drawn(12 - step, before=before, at=step * PASSING / 2)) for step in range(24)]
    usual = place(BEHIND)
    assert places.count(None) * PASSING / 2 > PASSING and set(places) == {usual, None}


def test_it_gives_way_to_a_robot_that_stays_and_stays_where_it_is_then() -> None:
    before = Arrangement()
    places = [place(drawn(max(10 - step, 4), before=before, at=step)) for step in range(20)]
    usual = place(BEHIND)
    arrived, aside = 6, places[-1]
    assert aside not in {usual, None} and places == [
        *[usual] * places.count(usual),
        *[None] * (arrived + round(PASSING) - places.count(usual)),
        *[aside] * places.count(aside),
    ]
    assert place(drawn(-10, before=before, at=20.0)) == aside
    back = [place(drawn(-10, before=before, at=21.0 + second)) for second in range(round(VACANT))]
    assert back == [aside] * (len(back) - 1) + [usual] and not before.labels.aside
    assert place(drawn(4)) == aside, "the first picture waits for nobody"


def test_it_comes_back_when_its_new_place_is_needed() -> None:
    before = Arrangement()
    drawn(5, before=before)
    (aside,) = before.labels.aside.values()
    y, x = place(BEHIND) or (0, 0)
    moved = [place(drawn(aside[0] - x + 3, aside[1] - y, before, at)) for at in (1.0, 1.0 + PASSING)]
    assert moved == [None, (y, x)] and not before.labels.aside


def test_a_replay_that_goes_back_leaves_no_label_out_for_long() -> None:
    before = Arrangement()
    drawn(10, before=before, at=100.0)
    assert place(drawn(5, before=before, at=100.0)) is None
    assert place(drawn(5, before=before, at=50.0)) is not None


def test_two_labels_of_one_cell_do_not_change_places() -> None:
    vertices = tuple(SceneVertex(id_, 10.05, 5.0, label=label) for id_, label in (("1", NAME), ("2", "Bay")))
    robots = tuple(SceneRobot(f"r{n}", n, Pose(10.05 + n * 3 * CELL, 5.0)) for n in range(3))
    scene = replace(SCENE, vertices=vertices, robots=robots)
    before, behind = Arrangement(), backdrop(scene, CAMERA, LOOK)
    texts = {picture(behind, scene, CAMERA, LOOK, before).text() for _ in range(4)}
    assert len(texts) == 1


def test_the_way_of_the_selected_robot_goes_on_where_a_label_gave_way_to_it() -> None:
    robot = SceneRobot("r", 7, Pose(10.05 + 3 * CELL, 5.0), selected=True)
    mission = Mission((), (), (10.05, 5.0, 18.0, 5.0))
    cells = picture(BEHIND, replace(SCENE, robots=(robot,), mission=mission), CAMERA, LOOK)
    y, x = place(BEHIND) or (0, 0)
    assert place(cells) not in (None, (y, x)), "it stands aside, for the robot is below it"
    assert (cells.roles[y, x + 4 : x + len(NAME)] == StyleRole.MISSION).all()
