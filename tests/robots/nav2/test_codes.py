"""Error codes of Nav2 in words."""

import pytest

from fleet_tui.robots.nav2.action_outcome import CODES, error_text


@pytest.mark.parametrize(
    ("code", "message", "detail"),
    [
        (104, "", "controller patience exceeded (error 104)"),
        (208, "", "no path to the goal (error 208)"),
        (208, "robot stuck", "no path to the goal (error 208): robot stuck"),
        (299, "", "planner (error 299)"),
        (901, "", "docking or navigation (error 901)"),
        (9001, "", "navigator failed (error 9001)"),
        (77, "", "error 77"),
        (-1, "", "error -1"),
    ],
)
def test_a_code_is_said_with_what_is_known_of_it(code: int, message: str, detail: str) -> None:
    assert error_text(code, message) == detail


def test_every_known_code_has_words() -> None:
    assert sorted(CODES) == [*range(101, 108), *range(201, 209), *range(600, 604)], "those of nav2_msgs"
    assert all(detail and detail in error_text(code) for code, detail in CODES.items())
