"""The map's first row: what is most important stands first, and a note is never left out."""

import math

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.caption import Caption, caption_row
from fleet_tui.view.map.drawing import Drawing
from tests.support.hostile_text import TEXTS


def row(
    width: int = 100,
    note: str = "",
    yaw: float = 0.0,
    drawing: Drawing = Drawing.BRAILLE,
    follow: bool = False,
    zoom_robot: bool = False,
    elsewhere: str = "",
) -> str:
    frame = MapFrame(0.05, 400, 200, Pose(0.0, 0.0, yaw))
    camera = Camera.fit((400, 200), width, 20)
    cells = caption_row(
        Caption("hall", note, frame, camera, drawing, follow, zoom_robot, False, elsewhere=elsewhere)
    )
    return "".join(chr(code) for code in cells.codes[0] if code)


def test_it_tells_the_floor_the_scale_and_what_is_switched_on() -> None:
    text = row(follow=True, zoom_robot=True)
    for words in (" hall ", " m ├", "follow on", "zoom robot"):
        assert words in text
    assert not [words for words in ("follow", "zoom") if words in row()]


def test_trouble_on_another_floor_comes_before_the_scale() -> None:
    assert "robot_9 on floor_1" in row(40, elsewhere="! robot_9 on floor_1")


def test_a_turned_map_says_by_how_much() -> None:
    assert "yaw 90°" in row(yaw=math.pi / 2) and "yaw" not in row()
    assert "yaw 90 deg" in row(yaw=math.pi / 2, drawing=Drawing.ASCII)


def test_a_long_note_is_cut_and_takes_the_rest_of_the_row() -> None:
    text = row(width=40, note="the map could not be read: " + "x" * 90)
    assert "the map could not be" in text and "…" in text and "follow" not in text


@given(TEXTS, st.integers(1, 120))
def test_it_is_always_as_wide_as_the_view(note: str, width: int) -> None:
    assert len(row(width, note)) <= width


def test_plain_is_ascii() -> None:
    assert row(drawing=Drawing.ASCII).isascii()
