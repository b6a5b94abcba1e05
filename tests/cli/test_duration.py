"""Spans of time as they are typed."""

import click
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.cli.duration import LONGEST, DurationParam


@pytest.mark.parametrize(
    ("typed", "seconds"), [("90", 90.0), ("45s", 45.0), ("30m", 1800.0), ("0.5h", 1800.0), ("1d", 86_400.0)]
)
def test_each_unit(typed: str, seconds: float) -> None:
    assert DurationParam().convert(typed, None, None) == seconds


@pytest.mark.parametrize("typed", ["", "0", "-1s", "1w", "1 h", "inf", "1e3", "367d", "9" * 10])
def test_what_is_none_is_answered_with_the_forms(typed: str) -> None:
    with pytest.raises(click.BadParameter, match="use 45s, 30m, 8h or 1d"):
        DurationParam().convert(typed, None, None)


@given(st.text(max_size=12))
def test_any_text_is_one_or_refused(typed: str) -> None:
    try:
        assert 0.0 < DurationParam().convert(typed, None, None) <= LONGEST
    except click.BadParameter:
        return
