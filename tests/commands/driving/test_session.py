"""A drive without a wire: capped, never beyond the hand, ended by faults, and zero in the end."""

import math
import random
from itertools import pairwise

import pytest

from fleet_tui.commands.driving.session import (
    ECHO_WITHIN,
    FOREIGN,
    LATEST,
    PERIOD,
    RETRY,
    ZEROS,
    DriveSession,
)
from fleet_tui.commands.driving.speed import Caps
from fleet_tui.model.set_up.driving import STILL, DrivePhase, Speeds, Steering
from fleet_tui.text.language import Message

CAPS = Caps(0.3, 0.6)
AHEAD = Speeds(0.3)


def ready(at: float = 0.0) -> DriveSession:
    session = DriveSession(CAPS, "/r/cmd_vel")
    assert session.begin(at) == [STILL]
    assert session.received(STILL, at) == []
    assert session.state.phase is DrivePhase.READY
    return session


def driven(session: DriveSession, start: float, until: float, stop: float) -> list[tuple[float, Speeds]]:
    """Let a hand drive ahead from a second until another, with every echo; return them to a third."""
    sent = [(start, frame) for frame in session.steer(Steering(AHEAD, until), start, True)]
    at = start
    while at < stop:
        for _, frame in sent[-1:]:
            session.received(frame, at)
        at += PERIOD
        sent += [(at, frame) for frame in session.tick(at, True)]
    return sent


def test_it_begins_with_the_echo_of_its_zero() -> None:
    session = DriveSession(CAPS, "/r/cmd_vel")
    session.begin(0.0)
    assert session.steer(Steering(AHEAD, 9.0), 0.1, True) == []
    assert session.is_active
    session.received(STILL, 0.2)
    assert session.state.round_trip == pytest.approx(0.2)
    assert session.steer(Steering(AHEAD, 9.0), 0.2, True)[0].ahead > 0.0


def test_without_an_echo_it_asks_again_and_ends() -> None:
    session = DriveSession(CAPS, "/r/cmd_vel")
    sent, at = session.begin(0.0), 0.0
    while at < ECHO_WITHIN + 2 * PERIOD:
        at += PERIOD
        sent += session.tick(at, True)
    assert session.state.reason == "no echo from /r/cmd_vel within 1.2 s"
    assert set(sent) == {STILL} and len(sent) > ZEROS + 1


def test_it_rises_ten_times_a_second_and_ends_a_movement_with_three_zeros() -> None:
    sent = driven(ready(), 1.0, 1.45, 3.0)
    assert [round(speeds.ahead, 2) for _, speeds in sent] == [0.05, 0.1, 0.15, 0.2, 0.25, 0, 0, 0]
    times = [at for at, _ in sent]
    assert all(after - before >= PERIOD - 1e-9 for before, after in pairwise(times))


def test_a_key_that_is_released_stops_it_at_once() -> None:
    session = ready()
    session.steer(Steering(AHEAD, 9.0), 1.0, True)
    assert session.steer(Steering(), 1.02, True) == [STILL]


def test_nothing_is_queued_behind_a_frame_on_its_way_but_a_zero_always_leaves() -> None:
    session = ready()
    assert session.steer(Steering(AHEAD, 9.0), 0.9, False) == []
    assert session.is_active and session.next_in == RETRY
    assert session.tick(1.0, True)[0].ahead > 0.0
    assert session.next_in == PERIOD
    session = ready()
    session.steer(Steering(AHEAD, 9.0), 1.0, True)
    assert session.tick(1.1, False) == []
    assert session.steer(Steering(), 1.15, False) == [STILL]


def test_a_screen_that_freezes_stops_it() -> None:
    session = ready()
    session.steer(Steering(AHEAD, 1.25), 1.0, True)
    assert session.tick(1.26, False) == [STILL]


def test_an_echo_that_stays_away_ends_it() -> None:
    session = ready()
    session.steer(Steering(AHEAD, 9.0), 1.0, True)
    assert session.tick(1.0 + LATEST + 0.01, True) == [STILL] * ZEROS
    assert session.state.reason.startswith("lag: no echo for 0.3 s")
    assert session.steer(Steering(AHEAD, 9.0), 1.4, True) == []


@pytest.mark.parametrize("foreign", [Speeds(0.07), Speeds(turning=0.9), Speeds(math.inf), Speeds(-0.3)])
def test_another_publisher_ends_it(foreign: Speeds) -> None:
    session = ready()
    session.steer(Steering(AHEAD, 9.0), 1.0, True)
    assert session.received(foreign, 1.05) == [STILL] * ZEROS
    assert (session.state.phase, session.state.reason) == (DrivePhase.ENDED, FOREIGN)
    assert session.end(Message("later")) == []


def test_another_publisher_keeps_it_from_beginning() -> None:
    session = DriveSession(CAPS, "/r/cmd_vel")
    session.begin(0.0)
    session.received(Speeds(0.2), 0.1)
    assert session.state.reason == FOREIGN


ANY = [0.0, 0.1, -0.3, 1e9, -1e9, math.inf, -math.inf, math.nan, 1e-12]


def one_session(seed: int) -> None:
    """Play one session with faults against a wire with any delay, and look at every frame on it."""
    chance = random.Random(seed)
    session, at, until = DriveSession(CAPS, "/r/cmd_vel"), 0.0, 0.0
    wire, lag = session.begin(at), chance.choice([0.0, 0.02, 0.1, 0.4])
    echoes = [(at + lag, frame) for frame in wire]
    for _ in range(chance.randint(1, 60)):
        at += chance.choice([0.001, 0.02, PERIOD, PERIOD, PERIOD, 0.7])
        clear = chance.random() < 0.9
        sent = []
        match chance.randint(0, 9):
            case 0 | 1 | 2:
                until = max(until, at + chance.choice([0.0, 0.25, 0.3]))
                asked = Speeds(*(chance.choice(ANY) for _ in range(3)))
                sent += session.steer(Steering(asked, until), at, clear)
            case 3 if chance.random() < 0.1:
                sent += session.received(Speeds(chance.choice(ANY)), at)
            case 4 if chance.random() < 0.2:
                sent += session.end(Message("the dialog"))
        while echoes and echoes[0][0] <= at:
            sent += session.received(echoes.pop(0)[1], at)
        sent += session.tick(at, clear)
        for frame in sent:
            assert math.hypot(frame.ahead, frame.sideways) <= CAPS.linear + 1e-9
            assert abs(frame.turning) <= CAPS.angular
            assert frame == STILL or at < until
        echoes += [(at + lag, frame) for frame in sent]
        wire += sent
    silent = at + 0.6
    while at < silent:
        at += PERIOD
        wire += session.tick(at, True)
    assert wire[-1] == STILL
    wire += session.end(Message("console closed"))
    assert wire[-ZEROS:] == [STILL] * ZEROS


@pytest.mark.parametrize("tenth", range(10))
def test_ten_thousand_sessions_with_faults_end_with_zero(tenth: int) -> None:
    for seed in range(1000 * tenth, 1000 * (tenth + 1)):
        one_session(seed)
