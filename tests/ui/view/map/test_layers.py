"""Layers of the map: labels whole or absent, robots on top, the cursor."""

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from fleet_tui.model.geometry import Pose
from fleet_tui.ui.view.map.layer_stack import backdrop
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import LABELS, StyleRole
from tests.support.drawn_hall import FIT, SCENE, drawn


def test_the_selected_robot_lies_on_top() -> None:
    pose = Pose(6.0, 2.3, 0.0)
    robots = tuple(SceneRobot(f"r{n}", n, structs.replace(pose, yaw=n), selected=n == 2) for n in (1, 2, 3))
    cells = drawn(replace(SCENE, robots=robots))
    x, y = FIT.to_cell(*SCENE.frame.to_pixel(6.0, 2.3))
    assert cells.roles[y, x] == StyleRole.ROBOT_SELECTED
    rows = cells.text().split("\n")
    assert rows[y][x + 1] == "2" and all(number in cells.text() for number in "13")


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
    for text, role in shown:
        assert "\x1b" not in text
        assert "\u202e" not in text
        if role in LABELS and text not in ("o", "·"):
            assert text in {_safe(label) for label in wanted}


def _safe(label: str) -> str:
    return label.replace("\x1b", "␛").replace("\u202e", "\ufffd").replace("\n", "␊")


def test_few_labels_cover_walls_of_many_only_an_orders_end_or_the_one_under_the_cursor() -> None:
    inside = (SceneVertex("1", 7.5, 5.8, label="Rack"),)
    near = FIT.zoomed(2.0, SCENE.frame.to_pixel(7.5, 5.8))
    scene = replace(SCENE, vertices=inside, robots=(), target_vertices=())
    assert "Rack" in backdrop(scene, near, MapOptions()).text()
    beside = tuple(SceneVertex(str(n), 6.0, 5.8 + n * 0.01, label="Bay") for n in range(2, 60))
    scene = replace(scene, vertices=(*inside, *beside))
    assert "Rack" not in backdrop(scene, near, MapOptions()).text()
    assert "Rack" in backdrop(replace(scene, target_vertices=("1",)), near, MapOptions()).text()
    assert "Rack" in backdrop(scene, near, MapOptions(pointed="1")).text()


def test_the_missions_ends_get_their_labels_first() -> None:
    crowd = tuple(SceneVertex(str(n), 6.0 + n * 0.01, 3.0, label=f"place {n}") for n in range(30))
    cells = backdrop(replace(SCENE, vertices=crowd, target_vertices=("29",)), FIT, MapOptions())
    assert "place 29" in cells.text()
    assert "place 28" not in cells.text()


def test_the_cursor_marks_its_cell() -> None:
    look = MapOptions(cursor=(6.0, 3.0))
    x, y = FIT.to_cell(*SCENE.frame.to_pixel(6.0, 3.0))
    assert drawn(look=look).roles[y, x] == StyleRole.CURSOR


def test_the_label_under_the_cursor_goes_before_the_others_but_not_before_the_missions() -> None:
    crowd = tuple(SceneVertex(str(n), 6.0 + n * 0.01, 3.0, label=f"place {n}") for n in range(30))
    scene = replace(SCENE, vertices=crowd, target_vertices=("29",))
    text = backdrop(scene, FIT, MapOptions(pointed="17")).text()
    assert "place 29" in text
    assert "place 17" in text
    assert "place 17" not in backdrop(scene, FIT, MapOptions()).text()
