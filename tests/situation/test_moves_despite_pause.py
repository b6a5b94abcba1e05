"""A paused robot that does not stand, by the speeds that it reports."""

from collections.abc import Callable
from random import Random

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import attention, report
from fleet_tui.model.alarm import Priority
from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import OdometryReported
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.situation.facts import DESPITE_PAUSE, STILL_MOVING, STOPPING
from fleet_tui.situation.reported_motion import LOCK, moves_despite_pause
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.lines.status import console_notes
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import R0, T0, WALL, reduced
from tests.support.nav2_goals import localised, nav2

AHEAD, SPINS, STANDS, CREEPS = Speeds(0.5), Speeds(turning=-1.0), Speeds(), Speeds(0.019, 0.0, 0.019)


def driven(
    state: FleetState, first: float, last: float, speed: Speeds | Callable[[], Speeds] | None
) -> FleetState:
    """A robot that reports a speed ten times a second, from one second to another after T0."""
    for tenth in range(round(first * 10), round(last * 10) + 1):
        at = T0 + tenth / 10
        newest = speed() if callable(speed) else speed
        state = reduced(state, OdometryReported(R0, at, Pose(0.0, 0.0), at, speed=newest))
        state = reduced(state, localised(at, 0.0), TimePassed(at, WALL + at))
    return state


def paused(speed: Speeds | None) -> FleetState:
    """A robot that reported a speed for a second and has just taken our pause."""
    state = driven(nav2(), 0.0, 1.0, speed)
    return replace(state, robots={R0: replace(state.robots[R0], paused_by_us=True, paused_since=T0 + 1)})


def told(state: FleetState) -> list[str]:
    return [text for text, _ in news(state, state.robots[R0])]


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


@pytest.mark.parametrize("speed", [AHEAD, SPINS])
def test_one_that_moves_is_stopping_and_not_paused(speed: Speeds) -> None:
    state = driven(paused(speed), 1.1, 2.0, speed)
    fact = moves_despite_pause(state, robot(state))
    assert fact is not None and fact.kind is STOPPING
    assert told(state) == [STOPPING.word] and console_notes(state, False, True, 0.0) == []
    assert reasons(state, robot(state))[0].name == STOPPING.word
    assert report(state)["robots"][0]["paused"] is False and not state.alarms


@pytest.mark.parametrize("speed", [STANDS, CREEPS])
def test_it_is_paused_after_half_a_second_at_rest(speed: Speeds) -> None:
    state = driven(paused(AHEAD), 1.1, 2.0, AHEAD)
    state = driven(state, 2.1, 2.5, speed)
    assert told(state) == [STOPPING.word]
    state = driven(state, 2.6, 2.7, speed)
    assert told(state) == ["stopped, no goal to keep"]
    assert console_notes(state, False, True, 0.0) == ["ALL PAUSED"]
    assert report(state)["robots"][0]["paused"] is True


def test_one_that_moves_on_after_three_seconds_is_told_everywhere_in_red() -> None:
    state = driven(paused(SPINS), 1.1, 5.0, SPINS)
    fact = moves_despite_pause(state, robot(state))
    assert fact is not None and (fact.kind, fact.priority) == (STILL_MOVING, Priority.HIGH)
    assert list(news(state, robot(state))) == [("still moving", StyleRole.ALARM)]
    (alarm,) = [one.condition for one in state.alarms if one.holds]
    assert (alarm.text, alarm.priority, alarm.remedy) == ("still moving", Priority.HIGH, fact.action)
    why = reasons(state, robot(state))[0]
    assert (why.name, why.remedy) == ("still moving", "Stop it by its own controls, or by its emergency stop")
    assert f"{R0}: still moving" in attention(state)


@pytest.mark.parametrize("turning", [0.0, 1.0])
def test_the_noise_of_its_speeds_at_rest_is_no_movement(turning: float) -> None:
    noise = Random(1)

    def measured() -> Speeds:
        return Speeds(noise.gauss(0.0, 0.02), turning=noise.gauss(0.0, 0.03))

    state = driven(paused(Speeds(turning=turning)), 1.1, 2.0, Speeds(turning=turning))
    state = driven(state, 2.1, 4.0, measured)
    for second in range(4, 20):
        state = driven(state, second + 0.1, second + 1, measured)
        assert told(state) == ["stopped, no goal to keep"] and not state.alarms, second


def test_a_slow_drive_is_movement_however_noisy_its_speeds_are() -> None:
    noise = Random(1)
    state = driven(paused(AHEAD), 1.1, 4.1, lambda: Speeds(max(0.0, 0.05 + noise.gauss(0.0, 0.02))))
    for tenth in range(42, 100):
        state = driven(state, tenth / 10, tenth / 10, lambda: Speeds(max(0.0, 0.05 + noise.gauss(0.0, 0.02))))
        assert told(state) in ([STILL_MOVING.word], [STOPPING.word])
    state = driven(state, 10.0, 10.0, Speeds(0.05))
    assert told(state) == [STILL_MOVING.word]


def test_the_alarm_is_over_as_it_stands_and_not_as_if_the_pause_had_ended() -> None:
    state = driven(driven(paused(SPINS), 1.1, 5.0, SPINS), 5.1, 6.5, STANDS)
    assert [(one.text, one.holds) for one in state.alarms] == [("stands now", False)]


def test_its_lock_is_the_next_means_where_there_is_one() -> None:
    state = driven(paused(SPINS), 1.1, 5.0, SPINS)
    locking = replace(robot(state), kind=replace(robot(state).kind, may_lock=True))
    fact = moves_despite_pause(state, locking)
    assert fact is not None and fact.action == LOCK


def test_one_that_stood_and_moves_again_is_driving_despite_the_pause() -> None:
    state = driven(paused(AHEAD), 1.1, 2.0, STANDS)
    state = driven(state, 2.1, 6.0, SPINS)
    assert told(state) == [DESPITE_PAUSE.word] and not state.alarms


def test_without_a_word_since_the_pause_it_is_not_seen_to_stop() -> None:
    state = paused(AHEAD)
    for second in range(2, 12):
        state = reduced(state, localised(T0 + second, 0.0), TimePassed(T0 + second, WALL + T0 + second))
    assert "not seen to stop" in told(state)


@pytest.mark.parametrize("speed", [None, STANDS])
def test_one_that_reports_no_speed_or_always_zero_is_paused_by_its_poses(speed: Speeds | None) -> None:
    state = driven(paused(speed), 1.1, 2.0, speed)
    assert moves_despite_pause(state, robot(state)) is None
    assert told(state) == ["stopped, no goal to keep"]
