"""The map mode of driving by hand: its words, within any width."""

import pytest

from fleet_tui.commands.driving.clearance import FAR
from fleet_tui.commands.driving.speed import Caps
from fleet_tui.model.set_up.driving import DrivePhase, DriveState, Speeds
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.modes.drive import DriveMode
from tests.support.map_pane import FRAME, SCENE


def mode(sent: Speeds = Speeds(), clearance: float | None = None, robot: str = "robot_0") -> DriveMode:  # noqa: B008  # a tuple
    it = DriveMode(robot, "floor_0", Caps(0.4, 0.6), frozenset(), lambda: None, lambda: None)
    it.state = DriveState(DrivePhase.READY, sent, round_trip=0.012)
    it.share, it.clearance = 0.5, clearance
    return it


def test_it_tells_speed_turn_clearance_and_round_trip() -> None:
    it = mode(Speeds(0.1, 0.0, -0.3), 1.24)
    assert it.banner("floor_0") == "DRIVE robot_0 0.10 m/s"
    assert it.gauges == "[##--    ]  1.2 m free  right 0.30 rad/s  12 ms"


@pytest.mark.parametrize(("metres", "text"), [(FAR, "over 2.0 m free"), (0.3, "SLOW 0.3 m free")])
def test_a_wall_is_told_in_words(metres: float, text: str) -> None:
    assert text in mode(Speeds(0.4), metres).gauges


def test_the_bar_is_full_at_the_cap_and_before_it_began_it_says_so() -> None:
    assert "[########]" in mode(Speeds(0.4)).gauges
    it = mode()
    it.state = DriveState()
    assert it.banner("floor_0") == "DRIVE robot_0: starting"


def test_a_name_from_outside_is_harmless() -> None:
    assert "\x1b" not in mode(robot="r\x1b[2J").banner("floor_0")


@pytest.mark.parametrize("width", [1, 5, 36, 100])
def test_the_gauges_are_written_over_the_map_and_never_beyond(width: int) -> None:
    it = mode(Speeds(0.1), 0.3)
    camera = Camera.fit((FRAME.width, FRAME.height), width, 10)
    cells = picture(backdrop(SCENE, camera, MapOptions()), SCENE, camera, MapOptions(), top=it.layers)
    assert cells.codes.shape == (10, width)
    first = "".join(map(chr, cells.codes[0]))
    assert first.startswith(" [##--    ]  SLOW 0.3 m free"[: max(width - 1, 0)])
