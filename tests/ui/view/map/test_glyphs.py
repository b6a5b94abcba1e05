"""The characters of the map: each says the same in plain ASCII."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Role
from fleet_tui.ui.view.map.glyphs import robot_glyph, robot_roles, robot_tag, vertex_glyph
from fleet_tui.ui.view.map.scene import SceneRobot
from fleet_tui.ui.view.roles import StyleRole

HERE = Pose(0.0, 0.0)


@pytest.mark.parametrize(
    ("yaw", "turned", "arrow", "plain"),
    [
        (0.0, 0.0, "→", ">"),
        (math.pi / 2, 0.0, "↑", "^"),
        (math.pi, 0.0, "←", "<"),
        (math.pi / 2, math.pi / 2, "→", ">"),
        (math.nan, 0.0, "→", ">"),
    ],
)
def test_the_arrow_points_where_the_robot_heads(yaw: float, turned: float, arrow: str, plain: str) -> None:
    robot = SceneRobot("r", 1, Pose(0.0, 0.0, yaw))
    assert (robot_glyph(robot, turned, False), robot_glyph(robot, turned, True)) == (arrow, plain)


def test_what_is_special_about_a_robot_stands_at_its_number() -> None:
    assert robot_tag(SceneRobot("r", 7, HERE), False) == "7"
    odd = SceneRobot("r", 7, HERE, cargo=True, obstacle=True, paused=True, jumped=True, other_map=True)
    assert (robot_tag(odd, False), robot_tag(odd, True)) == ("7!‖?≈", "7+!=?~")
    assert robot_tag(SceneRobot("r", 7, HERE, online=False, age=90.0), False) == "7 (90 s)"
    gone = SceneRobot("r", 7, HERE, online=False, age=90.0)
    assert (robot_tag(gone, False, False), robot_tag(gone, True, False)) == ("7○", "7-")


def test_trouble_goes_before_selection_and_selection_shows_in_the_arrow() -> None:
    offline = SceneRobot("r", 1, HERE, online=False, obstacle=True, selected=True)
    assert robot_roles(offline) == (StyleRole.ROBOT_SELECTED, StyleRole.ROBOT_OFFLINE)
    assert robot_roles(SceneRobot("r", 1, HERE)) == (StyleRole.ROBOT, StyleRole.ROBOT)


def test_a_vertex_by_its_role_then_by_its_label() -> None:
    assert [vertex_glyph(Role.ELEVATOR, True, plain)[0] for plain in (False, True)] == ["↕", "E"]
    assert vertex_glyph(Role.PLAIN, True, False)[0] == "o"


@given(st.floats(-9, 9) | st.just(math.nan), st.floats(-9, 9), st.booleans())
def test_plain_is_ascii(yaw: float, turned: float, cargo: bool) -> None:
    robot = SceneRobot("r", 1, Pose(0.0, 0.0, yaw), cargo=cargo, online=False)
    assert robot_glyph(robot, turned, True).isascii() and robot_tag(robot, True).isascii()
