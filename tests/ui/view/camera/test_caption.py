"""The line above the picture, and the text without one."""

import pytest

from fleet_tui.text.language import Message
from fleet_tui.ui.view.camera.caption import CameraFacts, caption, note


@pytest.mark.parametrize(
    ("facts", "text", "warns"),
    [
        (CameraFacts("r\x1b"), "Camera r␛", False),
        (CameraFacts("r1", (640, 480), 1.4, "2 fps"), "Camera r1  1 s  2 fps  640x480", False),
        (CameraFacts("r1", (640, 480), 4.0, "2 fps"), "Camera r1  old: 4 s  2 fps", True),
        (CameraFacts("r" * 40), "Camera " + "r" * 22 + "…", False),
    ],
)
def test_robot_size_age_and_rate_are_told(facts: CameraFacts, text: str, warns: bool) -> None:
    assert caption(facts, 30) == (text, warns)


def test_what_is_missing_is_told_in_the_place_of_the_picture() -> None:
    assert note(CameraFacts("r1")) == "waiting for the first picture"
    assert note(CameraFacts("r1", (4, 3), 9.9)) == ""
    assert note(CameraFacts("r1", (4, 3), 12.0)) == "no picture for 12 s"
    assert note(CameraFacts("r1", problem=Message("too large"))) == "no picture: too large"
    assert note(CameraFacts("r1", problem=Message("no camera: nothing publishes /c"))).startswith("no camera")
