"""Typed text never becomes commands: which keys act, by their order and their times alone."""

import string

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.terminal.typing import GAP, Fate, Typing

SOON, LATER = GAP / 2, GAP * 2


def fates(keys: str, typing: Typing, at: float, in_field: bool = False) -> list[Fate]:
    """The fates of printable keys that arrive at the same moment; `P` pauses all."""
    return [typing.judge(key, True, at, in_field, key == "P") for key in keys]


def after_a_word() -> Typing:
    """A word was typed into a form at 100 s, and its Enter closed the form."""
    typing = Typing()
    fates("Base", typing, 100.0, in_field=True)
    assert typing.judge("enter", True, 100.0, in_field=True) is Fate.ACTS
    return typing


def test_keys_act_where_nothing_was_typed() -> None:
    assert fates("opP", Typing(), 100.0) == [Fate.ACTS] * 3


def test_what_follows_a_form_without_a_gap_is_dropped_to_its_end_and_counted() -> None:
    typing = after_a_word()
    assert fates("yP", typing, 100.0 + SOON) == [Fate.DROPPED] * 2
    assert typing.judge("enter", True, 100.0 + 2 * SOON, False) is Fate.DROPPED
    assert typing.dropped == 3
    assert fates("p", typing, 100.0 + 2 * SOON + GAP) == [Fate.ACTS]
    assert typing.dropped == 0


def test_after_a_gap_they_act() -> None:
    assert fates("yP", after_a_word(), 100.0 + LATER) == [Fate.ACTS] * 2


def test_esc_ends_it_at_once_and_f12_and_arrows_always_act() -> None:
    typing = after_a_word()
    assert typing.judge("f12", False, 100.0, False) is Fate.ACTS
    assert typing.judge("down", False, 100.0, False) is Fate.ACTS
    assert fates("p", typing, 100.0) == [Fate.DROPPED]
    assert typing.judge("escape", False, 100.0, False) is Fate.ACTS
    assert fates("p", typing, 100.0) == [Fate.ACTS]


def test_the_next_form_gets_what_is_typed_into_it_after_a_gap() -> None:
    typing = after_a_word()
    assert fates("o", typing, 100.0 + LATER) == [Fate.ACTS]
    assert fates("Pack", typing, 100.0 + LATER, in_field=True) == [Fate.ACTS] * 4


def test_what_waited_during_a_standstill_is_dropped_in_fields_too() -> None:
    for in_field in (False, True):
        typing = Typing()
        typing.stood_still(100.0)
        assert fates("xyP", typing, 100.1, in_field) == [Fate.DROPPED] * 3
        assert (typing.dropped, typing.is_blind) == (3, True)
        assert fates("x", typing, 100.1 + LATER, in_field) == [Fate.ACTS]


def test_keys_pressed_long_before_the_end_of_a_standstill_do_not_end_it() -> None:
    """A blocked loop: the thread that reads keys went on, and dated them."""
    typing = Typing()
    typing.stood_still(105.0)
    assert [fates(key, typing, at) for key, at in (("a", 101.0), ("r", 102.0), ("y", 104.9))] == [
        [Fate.DROPPED]
    ] * 3
    typing.stood_still(105.1)
    assert fates("P", typing, 103.0) == [Fate.DROPPED] and typing.dropped == 4


def test_a_pause_of_all_acts_after_a_standstill_if_it_alone_waited() -> None:
    typing = Typing()
    typing.stood_still(100.0)
    assert fates("PP", typing, 100.1) == [Fate.WAITS] * 2
    assert typing.is_alone
    typing.stood_still(100.2)  # the terminal is still not read: nothing starts over
    assert typing.is_alone
    assert fates("x", typing, 100.3) == [Fate.DROPPED]
    assert not typing.is_alone and typing.dropped == 2


@given(
    st.lists(
        st.tuples(
            st.sampled_from([*string.ascii_letters, "enter"]),
            st.sampled_from([0.0, 0.1, 0.4, 0.49, 0.5, 0.6, 3.0]),
            st.booleans(),
        )
    )
)
def test_no_key_acts_as_a_command_within_a_gap_of_typed_text(keys: list[tuple[str, float, bool]]) -> None:
    typing, at, typed_at = Typing(), 100.0, 0.0
    for key, gap, in_field in keys:
        at += gap
        fate = typing.judge(key, True, at, in_field)
        if in_field:
            assert fate is Fate.ACTS
        else:
            assert (fate is Fate.DROPPED) == (at - typed_at < GAP)
        if in_field or fate is Fate.DROPPED:
            typed_at = at
