"""The map mode of poses and goals."""

import math

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.modes.place import PlaceMode
from fleet_tui.ui.view.map.viewport import Viewport
from tests.support.map_pane import FRAME, SCENE

CAMERA = Camera.fit((FRAME.width, FRAME.height), 100, 29)


def mode(yaw: float = 0.0) -> PlaceMode:
    return PlaceMode(Message("POSE"), "robot_0", "floor_0", Pose(10.0, 5.0, yaw))


def test_the_heading_turns_by_degrees_and_stays_within_half_a_turn() -> None:
    it = mode(math.radians(178))
    it.turn(5)
    assert math.degrees(it.yaw) == pytest.approx(-177)
    assert it.banner("floor_0") == "POSE 10.00, 5.00 m, -177 degrees, robot_0"
    it.note = Message("4 % fit, 1.95 m")
    assert it.banner("floor_1") == "POSE floor_0 10.00, 5.00 m, 4 % fit, 1.95 m, -177 degrees, robot_0"


def test_the_mouse_places_and_a_drag_turns() -> None:
    it = mode()
    assert it.press(Viewport(100, 29), SCENE, (4.0, 4.0))
    it.drag((4.0, 4.0))
    it.drag((4.0, 9.0))
    assert (it.pose.x, it.pose.y) == (4.0, 4.0) and it.yaw == pytest.approx(math.pi / 2)


@pytest.mark.parametrize(
    ("yaw", "seen"), [(0.0, "→"), (math.pi / 2, "↑"), (math.pi, "←"), (-math.pi / 4, "↘")]
)
def test_the_place_is_drawn_with_its_heading(yaw: float, seen: str) -> None:
    look, it = MapOptions(), mode(yaw)
    alone = type(SCENE)("floor_0", FRAME)
    text = picture(backdrop(alone, CAMERA, look), alone, CAMERA, look, None, it.layers).text()
    assert seen in text and text.count("•") == 3
    elsewhere = type(SCENE)("floor_1", FRAME)
    text = picture(backdrop(elsewhere, CAMERA, look), elsewhere, CAMERA, look, None, it.layers).text()
    assert seen not in text
