"""Errors that name the remedy: the nearest right word, and words that can only be addresses."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.errors import ConfigError, did_you_mean, is_address


@pytest.mark.parametrize(
    ("word", "suggestion"),
    [
        ("poes", ", did you mean pose?"),
        ("POSE", ", did you mean pose?"),
        ("batery", ", did you mean battery?"),
        ("xyzzy", ""),
        ("", ""),
        ("pose" * 100_000, ", did you mean pose?"),
    ],
)
def test_only_a_near_name_is_suggested(word: str, suggestion: str) -> None:
    found = did_you_mean(word, ["pose", "battery"])
    assert found == suggestion or len(word) > 80


@given(st.text(max_size=20), st.lists(st.text(max_size=10)))
def test_a_suggestion_is_a_known_name(word: str, known: list[str]) -> None:
    found = did_you_mean(word, known)
    assert found == "" or found.removeprefix(", did you mean ").removesuffix("?") in known


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        ("ws://robot", True),
        ("robot:9090", True),
        ("10.0.0.1:9090/path", True),
        ("robot", False),
        ("status", False),
        (":9090", False),
        ("C:\\maps", False),
    ],
)
def test_what_can_only_be_an_address(word: str, expected: bool) -> None:
    assert is_address(word) is expected


def test_every_problem_of_a_configuration_is_a_line() -> None:
    problem = ConfigError(["one: is wrong", "two: too"])
    assert str(problem).splitlines() == problem.problems
