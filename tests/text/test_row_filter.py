"""Typed conditions on rows."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.row_filter import filter_terms, is_wanted

NAMES = ("robot", "floor", "state")
ROW = {"robot": "robot_12", "floor": "Floor_1", "state": "paused"}


def wanted(typed: str, row: dict[str, str] | None = None) -> bool:
    values = row or ROW
    return is_wanted(
        filter_terms(typed, NAMES),
        lambda name: (values[name] if name else "\n".join(values.values())).casefold(),
    )


@pytest.mark.parametrize(
    ("typed", "is_shown"),
    [
        ("", True),
        ("12", True),
        ("13", False),
        ("PAUSED floor", True),
        ("paused idle", False),
        ("!paused", False),
        ("!idle", True),
        ("robot:1", True),
        ("floor:12", False),
        ("!floor:0", True),
        ("!floor:1", False),
        ("paused !floor:0 robot:12", True),
    ],
)
def test_all_conditions_must_hold(typed: str, is_shown: bool) -> None:
    assert wanted(typed) is is_shown


@pytest.mark.parametrize("typed", ["!", "floor:", "!floor:", "robot: !"])
def test_a_condition_that_is_not_typed_to_its_end_hides_nothing(typed: str) -> None:
    assert wanted(typed)


def test_a_colon_after_another_word_is_text() -> None:
    assert wanted("12:04", {"robot": "r", "floor": "", "state": "since 12:04"})
    assert not wanted("12:04")


@given(st.text(), st.text())
def test_a_word_and_its_opposite_never_both_hold(typed: str, value: str) -> None:
    word = "".join(typed.split()).removeprefix("!")
    row = {"robot": value, "floor": "", "state": ""}
    for one in filter_terms(word, NAMES):
        assert one.wanted
        assert wanted(word, row) is not wanted(f"!{word}", row)
