"""The line above the picture, and the text without one."""

import pytest

from fleet_tui.view.camera.caption import Facts, caption, note


@pytest.mark.parametrize(
    ("facts", "text", "warns"),
    [
        (Facts("r\x1b"), "Camera of r␛", False),
        (Facts("r1", (640, 480), 1.4, "2 fps"), "Camera of r1  640x480  1 s  2 fps", False),
        (Facts("r1", (640, 480), 4.0, "2 fps"), "Camera of r1  640x480  old: 4 s  2 fps", True),
    ],
)
def test_robot_size_age_and_rate_are_told(facts: Facts, text: str, warns: bool) -> None:
    assert caption(facts) == (text, warns)


def test_what_is_missing_is_told_in_the_place_of_the_picture() -> None:
    assert note(Facts("r1")) == "waiting for the first picture"
    assert note(Facts("r1", (4, 3), 9.9)) == ""
    assert note(Facts("r1", (4, 3), 12.0)) == "no picture for 12 s"
    assert note(Facts("r1", problem="too large")) == "no picture: too large"
