"""Echoes: ours come back, others' are told apart, and what stays away is late."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.driving.session import MOST, OURS_FOR, Echoes
from fleet_tui.model.set_up.driving import STILL, Speeds

SPEED = st.builds(Speeds, st.floats(-1, 1), st.just(0.0), st.floats(-1, 1))


def test_a_frame_without_an_echo_gets_late_and_its_echo_tells_the_round_trip() -> None:
    echoes = Echoes().sent(Speeds(0.1), 1.0)
    assert echoes.late(1.25) == pytest.approx(0.25)
    back = echoes.received(Speeds(0.1), 1.2)
    assert back is not None
    assert back.round_trip == pytest.approx(0.2)
    assert back.late(9.0) == 0.0


def test_zeros_that_were_lost_are_never_late() -> None:
    assert Echoes().sent(STILL, 1.0).late(60.0) == 0.0


def test_an_echo_makes_up_for_those_before_it_that_were_lost() -> None:
    echoes = Echoes().sent(Speeds(0.1), 1.0).sent(Speeds(0.2), 1.1).received(Speeds(0.2), 1.2)
    assert echoes is not None
    assert echoes.late(5.0) == 0.0


def test_a_frame_with_other_values_is_another_publishers() -> None:
    echoes = Echoes().sent(Speeds(0.1), 1.0)
    assert echoes.received(Speeds(0.3), 1.1) is None
    assert echoes.received(Speeds(0.1, 0.0, 0.5), 1.1) is None


def test_ours_may_come_twice_but_not_much_later() -> None:
    echoes = Echoes().sent(Speeds(0.1), 1.0).received(Speeds(0.1), 1.1)
    assert echoes is not None
    assert echoes.received(Speeds(0.1), 1.5) is not None
    assert echoes.received(Speeds(0.1), 1.0 + OURS_FOR + 0.1) is None


@given(st.lists(SPEED, max_size=2 * MOST), st.data())
def test_echoes_in_order_with_gaps_are_all_ours(frames: list[Speeds], data: st.DataObject) -> None:
    echoes, at = Echoes(), 0.0
    for frame in frames:
        at += 0.1
        echoes = echoes.sent(frame, at)
        if data.draw(st.booleans()):
            found = echoes.received(frame, at + 0.05)
            assert found is not None
            echoes = found
        assert len(echoes.waiting) <= MOST
        assert len(echoes.returned) <= MOST
