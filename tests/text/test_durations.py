"""Spans of time as a person reads them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.units import age, duration


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (-3.0, "0 s"),
        (4.4, "4 s"),
        (99.4, "99 s"),
        (119.4, "119 s"),
        (119.6, "2 min"),
        (179.0, "2 min"),
        (7199.0, "119 min"),
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


def test_tenths_while_it_is_short() -> None:
    assert [duration(seconds) for seconds in (-1.0, 4.23, 9.94, 9.96, 76.2, 130.0)] == [
        "0.0 s",
        "4.2 s",
        "9.9 s",
        "10 s",
        "76 s",
        "2 min",
    ]
