"""Error codes of Nav2 in words."""

import pytest

from fleet_tui.adapters.nav2.codes import CODES, in_words


@pytest.mark.parametrize(
    ("code", "message", "words"),
    [
        (208, "", "error 208 (no path to the goal)"),
        (208, "robot stuck", "error 208 (no path to the goal): robot stuck"),
        (299, "", "error 299 (planner)"),
        (901, "", "error 901 (docking or navigation)"),
        (9001, "", "error 9001 (navigator failed)"),
        (77, "", "error 77"),
        (-1, "", "error -1"),
    ],
)
def test_a_code_is_said_with_what_is_known_of_it(code: int, message: str, words: str) -> None:
    assert in_words(code, message) == words


def test_every_known_code_has_words() -> None:
    assert all(words and words in in_words(code) for code, words in CODES.items())
