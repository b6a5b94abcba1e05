"""Speeds: never above a cap, up slowly, down at once, slower before a wall."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.driving.hold import DIRECTIONS, TAP, Hand
from fleet_tui.commands.driving.speed import (
    CREEP,
    FIRST,
    RISE,
    SLOW_WITHIN,
    Caps,
    capped,
    faster,
    next_speeds,
    slowed,
    wanted,
)
from fleet_tui.model.set_up.driving import STILL, Speeds

ANY = st.floats(allow_nan=True, allow_infinity=True)
FINITE = st.floats(-1e6, 1e6)
CAPS = st.builds(Caps, st.floats(0.01, 5.0), st.floats(0.01, 5.0))
EVENTS = st.lists(st.tuples(st.sampled_from([*DIRECTIONS, "+", "-", ""]), st.floats(0.0, 1.0)), max_size=80)
PERIOD = 0.1


def is_within(speeds: Speeds, caps: Caps) -> bool:
    linear = math.hypot(speeds.ahead, speeds.sideways)
    return linear <= caps.linear * (1 + 1e-9) and abs(speeds.turning) <= caps.angular


@given(EVENTS, CAPS)
def test_no_order_of_keys_exceeds_a_cap_or_drives_on_in_silence(
    events: list[tuple[str, float]], caps: Caps
) -> None:
    """Plays keys at any times against a clock of frames."""
    hand, share, at, frame_at, sent = Hand(), FIRST, 0.0, 0.0, STILL
    presses = list(events)
    last_press, due = 0.0, presses[0][1] if presses else math.inf
    while at < 90.0 and (presses or at <= last_press + 0.6):
        at += PERIOD
        while presses and due <= at:
            key, _ = presses.pop(0)
            last_press = due
            if key in DIRECTIONS:
                hand = hand.pressed(key, due)
            else:
                share = faster(share, {"+": 1, "-": -1}.get(key, 0))
            due += presses[0][1] if presses else 0.0
        sent = next_speeds(sent, wanted(hand, at, share, caps), at - frame_at, caps)
        frame_at = at
        assert is_within(sent, caps)
        assert sent == STILL or at <= last_press + TAP + PERIOD
    assert sent == STILL or at >= 90.0


@given(st.builds(Speeds, ANY, ANY, ANY), st.builds(Speeds, ANY, ANY, ANY), st.floats(0.0, 1e6), CAPS)
def test_whatever_is_asked_for_stays_within_the_caps(
    before: Speeds, target: Speeds, seconds: float, caps: Caps
) -> None:
    before = before if all(map(math.isfinite, before)) else STILL
    assert is_within(next_speeds(capped(before, caps), target, seconds, caps), caps)


@given(st.builds(Speeds, FINITE, FINITE, FINITE), CAPS)
def test_a_stop_is_at_once(before: Speeds, caps: Caps) -> None:
    assert next_speeds(before, STILL, 0.0, caps) == STILL


def test_it_rises_by_half_a_metre_per_second_each_second_and_falls_at_once() -> None:
    caps = Caps(2.0, 1.0)
    first = next_speeds(STILL, Speeds(2.0), 0.1, caps)
    assert first.ahead == pytest.approx(RISE * 0.1)
    assert next_speeds(Speeds(1.0), Speeds(0.4), 0.1, caps) == Speeds(0.4)


def test_it_goes_through_zero_on_the_way_back() -> None:
    assert next_speeds(Speeds(1.0), Speeds(-1.0), 0.1, Caps(2.0, 1.0)).ahead == pytest.approx(-RISE * 0.1)


def test_ahead_and_sideways_together_keep_their_direction_at_the_cap() -> None:
    speeds = capped(Speeds(3.0, 4.0, 9.0), Caps(1.0, 0.5))
    assert speeds == pytest.approx((0.6, 0.8, 0.5))


def test_keys_ask_for_a_share_of_the_caps() -> None:
    hand = Hand().pressed("s", 1.0).pressed("a", 1.1)
    assert wanted(hand, 1.1, 0.5, Caps(0.4, 1.0)) == Speeds(-0.2, 0.0, 0.5)
    assert wanted(hand, 9.0, 0.5, Caps(0.4, 1.0)) == STILL


def test_the_share_stays_between_its_ends() -> None:
    assert faster(FIRST, 99) == 1.0
    assert 0.0 < faster(FIRST, -99) <= FIRST


@given(st.builds(Speeds, st.floats(-1, 1), st.floats(-1, 1), st.floats(-1, 1)), st.floats(-1.0, 5.0))
def test_a_wall_only_slows_and_always_leaves_a_way_out(speeds: Speeds, clearance: float) -> None:
    found = slowed(speeds, clearance)
    before, after = (math.hypot(one.ahead, one.sideways) for one in (speeds, found))
    assert found.turning == speeds.turning
    assert min(before, CREEP) - 1e-9 <= after <= before + 1e-9
    assert clearance < SLOW_WITHIN or found == speeds
