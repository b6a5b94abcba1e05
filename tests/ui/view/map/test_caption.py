"""The map's first row: what is most important stands first, and a note is never left out."""

import math
import re
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.map_picture import Caption, caption_row
from fleet_tui.ui.view.roles import StyleRole
from tests.support.hostile_text import TEXTS


def row(
    width: int = 100,
    note: str = "",
    yaw: float = 0.0,
    drawing: Drawing = Drawing.BRAILLE,
    follow: bool = False,
    zoom_robot: bool = False,
    elsewhere: str = "",
    banner: str = "",
    pixel: str = "",
    floor: str = "hall",
    whole: bool = False,
) -> str:
    frame = MapFrame(0.05, 400, 200, Pose(0.0, 0.0, yaw))
    camera = Camera.fit((400, 200), width, 20)
    facts = Caption(floor, note, frame, camera, drawing, follow, zoom_robot, False)
    cells = caption_row(
        replace(facts, elsewhere=(elsewhere,) if elsewhere else (), banner=banner, pixel=pixel, whole=whole)
    )
    return "".join(chr(code) for code in cells.codes[0] if code)


def test_it_tells_the_floor_the_scale_and_what_is_switched_on() -> None:
    text = row(follow=True, zoom_robot=True)
    for words in (" hall ", " m ├", "follow on", "zoom robot"):
        assert words in text
    assert not [words for words in ("follow", "zoom") if words in row()]


@pytest.mark.parametrize("width", [37, 60, 100, 140])
def test_the_ends_of_the_scale_bar_are_as_far_apart_as_it_says(width: int) -> None:
    for drawing, ends in ((Drawing.BRAILLE, "├┤"), (Drawing.ASCII, "||")):
        text = row(width, drawing=drawing)
        (metres,) = re.findall(rf"(\d+) m [{ends[0]}]", text)
        cell = 400 * 0.05 / _columns(width)
        assert abs((text.rindex(ends[1]) - text.index(ends[0])) * cell - int(metres)) <= cell / 2


def _columns(width: int) -> float:
    """Return the cells that a map of 20 m takes, fitted in so many."""
    camera = Camera.fit((400, 200), width, 20)
    return 400 / (2 * camera.scale)


def test_it_tells_why_a_view_that_follows_does_not_move() -> None:
    assert " floor_0 ── follow on, all in view " in row(37, follow=True, whole=True, floor="floor_0")
    assert "in view" not in row(follow=True) and "in view" not in row(whole=True)


def test_trouble_on_another_floor_comes_before_the_scale() -> None:
    assert "robot_9 on floor_1" in row(40, elsewhere="! robot_9 on floor_1")


def test_of_those_elsewhere_only_an_alarm_is_red() -> None:
    frame = MapFrame(0.05, 400, 200, Pose(0.0, 0.0))
    facts = Caption("hall", "", frame, Camera.fit((400, 200), 60, 20), Drawing.BRAILLE, False, False, False)
    for elsewhere, role in (("! r on f", StyleRole.ALARM), ("look at r on f", StyleRole.WARN)):
        assert role in caption_row(replace(facts, elsewhere=(elsewhere,))).roles
    both = caption_row(replace(facts, elsewhere=("! r out of view", "look at s on f")))
    assert {StyleRole.ALARM, StyleRole.WARN} <= set(both.roles.flat)


def test_the_place_of_a_cursor_is_readable_in_a_narrow_pane() -> None:
    banner = "EDIT -118.00, -112.25 m 11E 20W, from Base 3.0 m"
    text = row(38, elsewhere="! robot_9 on floor_1", banner=banner, pixel="cell 7, 9", floor="floor_0")
    assert " EDIT -118.00, -112.25 m 11E 20W" in text
    for floor in ("floor_0", "x" * 60):
        assert "GOAL -18.00, 12.25 m" in row(38, banner="GOAL -18.00, 12.25 m", floor=floor)


def test_where_there_is_space_the_floor_and_the_cell_are_shown_too() -> None:
    text = row(60, banner="EDIT 18.00, 12.25 m 2W", pixel="cell 360, 245", floor="floor_0")
    assert " floor_0 ── EDIT 18.00, 12.25 m 2W ── cell 360, 245 " in text


def test_a_turned_map_says_by_how_much() -> None:
    assert "yaw 90°" in row(yaw=math.pi / 2) and "yaw" not in row()
    assert "yaw 90 deg" in row(yaw=math.pi / 2, drawing=Drawing.ASCII)


def test_of_a_note_the_parts_are_whole_that_have_space() -> None:
    text = row(width=37, note="robot_17: no pose yet, no map and no graph yet", floor="floor_0")
    assert " robot_17: no pose yet " in text and "no map" not in text and "…" not in text


def test_a_long_note_is_cut_and_takes_the_rest_of_the_row() -> None:
    text = row(width=40, note="the map could not be read: " + "x" * 90)
    assert "the map could not be" in text and "…" in text and "follow" not in text


@given(TEXTS, st.integers(1, 120))
def test_it_is_always_as_wide_as_the_view(note: str, width: int) -> None:
    assert len(row(width, note)) <= width


def test_plain_is_ascii() -> None:
    assert row(drawing=Drawing.ASCII).isascii()
