"""Fields that a site has at other paths are put where the kind has them, and nothing else changes."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.robots.ros.fields import placed, put, rearranged
from fleet_tui.text.errors import WireError

NAMES = st.sampled_from(["a", "b", "c"])
MESSAGES: Any = st.dictionaries(
    NAMES, st.recursive(st.integers(), lambda inner: st.dictionaries(NAMES, inner))
)
PATHS = st.lists(NAMES, min_size=1, max_size=3).map(".".join)


def value(message: Any, path: str) -> Any:
    for step in path.split("."):
        message = message[step]
    return message


def test_a_field_is_copied_to_its_usual_path() -> None:
    message = {"state": {"percentage": 0.5, "voltage": 24.0}}
    assert rearranged(message, {"data": ("data", "state.percentage")}) == {**message, "data": 0.5}


def test_what_lies_deeper_is_put_last() -> None:
    """The whole may come from one place and a part of it from another."""
    paths = {"x": ("pose.x", "where.x"), "pose": ("pose", "place")}
    assert rearranged({"place": {"x": 1, "y": 2}, "where": {"x": 9}}, paths)["pose"] == {"x": 9, "y": 2}


def test_a_field_that_is_missing_is_named_with_its_path() -> None:
    with pytest.raises(WireError, match=r"`b` - at `\$.a.b`: correct the fields of its profile"):
        rearranged({"a": {"c": 1}}, {"data": ("data", "a.b")})


@given(MESSAGES, PATHS, st.integers())
def test_what_was_put_is_there_and_parts_of_others_stay_as_they_were(
    message: dict[str, Any], path: str, number: int
) -> None:
    before = repr(message)
    copy = dict(message)
    put(copy, path, number)
    assert value(copy, path) == number
    assert repr(message) == before


def test_a_pose_has_seven_numbers_and_their_two_parts() -> None:
    assert placed("pose.")["orientation.w"] == "pose.orientation.w"
    assert len(placed("")) == 9
