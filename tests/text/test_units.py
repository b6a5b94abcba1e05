"""Sizes, rates and ages as a person reads them."""

import pytest

from fleet_tui.text.units import ago, counted, milliseconds, percent, size_text


@pytest.mark.parametrize(
    ("count", "words"),
    [(0, "0 B"), (999, "999 B"), (1000, "1.0 kB"), (1_234_567, "1.2 MB"), (999_900, "999.9 kB")],
)
def test_sizes(count: int, words: str) -> None:
    assert size_text(count) == words


def test_how_long_ago_something_was() -> None:
    assert ago(None, 5.0) == "never"
    assert (ago(4.5, 5.0), ago(9.0, 5.0), ago(0.0, 20.0)) == ("0.5 s ago", "0.0 s ago", "20 s ago")


def test_short_spans() -> None:
    assert (milliseconds(0.00042), milliseconds(0.012)) == ("0.42 ms", "12 ms")


def test_a_count_has_its_noun() -> None:
    assert counted(1, "error") == "1 error"
    assert (counted(0, "error"), counted(2, "vertex", "vertices")) == ("0 errors", "2 vertices")


def test_shares_have_a_space_before_the_sign() -> None:
    assert (percent(0.0), percent(0.044), percent(1.0)) == ("0 %", "4 %", "100 %")
