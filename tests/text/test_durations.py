"""Spans of time as a person reads them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.durations import age


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (-3.0, "0 s"),
        (4.4, "4 s"),
        (99.4, "99 s"),
        (100.0, "2 min"),
        (5999.0, "100 min"),
        (7200.0, "2 h"),
        (math.inf, "never"),
        (math.nan, "never"),
    ],
)
def test_one_format(seconds: float, words: str) -> None:
    assert age(seconds) == words


@given(st.floats())
def test_any_span_is_short(seconds: float) -> None:
    assert age(seconds) == "never" or age(seconds).split()[1] in ("s", "min", "h")
