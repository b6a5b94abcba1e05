"""Held keys: driven while they repeat, released soon after, and never prolonged by what a terminal kept."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.driving.hold import BURST, DIRECTIONS, RELEASED_AFTER, TAP, Hand
from fleet_tui.model.set_up.driving import Axis

KEYS = st.sampled_from(sorted(DIRECTIONS))
GAPS = st.floats(0.0, 2.0)


def played(presses: list[tuple[str, float]], at: float = 0.0) -> tuple[Hand, float]:
    """Return the hand after presses, each so many seconds after the one before, and the time of the last."""
    hand = Hand()
    for key, gap in presses:
        at += gap
        hand = hand.pressed(key, at)
    return hand, at


def test_one_press_drives_for_its_time() -> None:
    hand = Hand().pressed("w", 10.0)
    assert hand.signs(10.0) == {Axis.AHEAD: 1}
    assert hand.signs(10.0 + TAP - 0.01) == {Axis.AHEAD: 1}
    assert hand.signs(10.0 + TAP) == {}


def test_a_held_key_is_released_sooner_after_its_last_repeat() -> None:
    hand, last = played([("w", 0.0), ("w", 0.5), *[("w", 0.03)] * 20])
    assert hand.signs(last + RELEASED_AFTER - 0.01)
    assert not hand.signs(last + RELEASED_AFTER)


def test_two_keys_drive_two_axes_and_opposite_ones_replace_each_other() -> None:
    hand, last = played([("w", 0.0), ("a", 0.1)])
    assert hand.signs(last) == {Axis.AHEAD: 1, Axis.TURNING: 1}
    assert hand.pressed("s", last + 0.05).signs(last + 0.05) == {Axis.AHEAD: -1, Axis.TURNING: 1}


def test_a_release_that_is_told_ends_it_at_once() -> None:
    hand, last = played([("w", 0.0), ("a", 0.1)])
    assert hand.released("w").signs(last) == {Axis.TURNING: 1}


def test_repeats_of_a_held_key_that_arrive_together_do_not_stop_it() -> None:
    hand, last = played([("w", 0.0), ("w", 0.5), ("w", 0.03), ("w", 0.06), ("w", 0.001)])
    assert hand.signs(last + 0.1) == {Axis.AHEAD: 1}


@given(st.lists(st.tuples(KEYS, GAPS), max_size=60))
def test_nothing_drives_longer_than_a_tap_after_the_last_key(presses: list[tuple[str, float]]) -> None:
    hand, last = played(presses)
    assert not hand.signs(last + TAP + 1e-9)


@given(
    st.lists(st.tuples(KEYS, GAPS), max_size=30),
    KEYS,
    st.lists(st.tuples(KEYS, st.floats(0.0, BURST * 0.9)), max_size=200),
)
def test_presses_of_a_burst_prolong_nothing(
    before: list[tuple[str, float]], first: str, burst: list[tuple[str, float]]
) -> None:
    hand, at = played([*before, (first, 1.0)])
    until = hand.until
    for key, gap in burst:
        at += gap
        hand = hand.pressed(key, at)
    assert hand.until <= until


@given(KEYS, st.integers(2, 200), st.floats(0.0, BURST * 0.9))
def test_a_key_that_a_stalled_terminal_kept_drives_nothing(key: str, presses: int, gap: float) -> None:
    hand, last = played([(key, 5.0), *[(key, gap)] * (presses - 1)])
    assert not hand.signs(last)
