"""Limits on input from outside: what is cut says so."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.language import Message
from fleet_tui.text.limits import some, too_many, truncate


@given(st.text(), st.integers(0, 50))
def test_a_text_is_whole_or_says_how_long_it_is(text: str, longest: int) -> None:
    cut = truncate(text, longest)
    if len(text) <= longest:
        assert cut == text
    else:
        assert cut == f"{text[:longest]}… ({len(text):,} characters)"


def test_a_list_that_is_too_long_is_said() -> None:
    assert too_many(3, 3, Message("orders")) == ""
    assert too_many(4000, 3, Message("orders")) == "4,000 orders: only the first 3 used"


def test_the_first_three_are_named() -> None:
    assert (some([]), some(["a", "b", "c"]), some(["a", "b", "c", "d"])) == ("", "a, b, c", "a, b, c, …")
