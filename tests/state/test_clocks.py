"""The age of the first message of a robot: by the clock of its site, else unknown."""

import pytest

from fleet_tui.cli.status.report import attention, report
from fleet_tui.commands.checks import problems
from fleet_tui.model.events import BridgeAnswered, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import MemberReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import LocalisationReported
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.situation.links import late_link
from fleet_tui.situation.robots import silent
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import F0, LINK, R0, T0, fleet, link_lost, link_up, place_order, pose, reduced, tick

SITE = 5_000.0
"""The clock of the site at T0."""


def seen(*facts: Event, robots: int = 1) -> FleetState:
    return reduced(fleet(robots), link_up(T0 - 1), *facts, tick(T0 + 0.5))


def age(state: FleetState) -> float:
    reading = state.robots[R0].pose
    assert reading is not None
    return state.now - reading.at


def told(state: FleetState) -> list[str]:
    return [text for text, _ in news(state, state.robots[R0])]


def asked(state: FleetState) -> list[str]:
    request = Request((place_order(R0, 1, 2),))
    return [one.check for one in problems(state, request, Permissions(False, True))]


def test_a_first_stamp_is_as_old_as_the_clock_of_the_site_says() -> None:
    state = seen(BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5), pose(T0, stamp=SITE - 40.0))
    assert round(age(state), 1) == 40.5 and not state.is_online(state.robots[R0])
    assert told(state)[0] == "offline 40 s" and "offline" in asked(state)
    assert "robot_0: offline 40 s" in attention(state)
    assert [one["online"] for one in report(state)["robots"]] == [False]


def test_a_first_stamp_ahead_of_the_site_is_of_unknown_age_and_of_a_clock_that_runs_none() -> None:
    """A stamp of the future proves nothing: the message may be a latched one."""
    ahead = seen(BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5), pose(T0, stamp=SITE + 3600.0))
    assert not ahead.is_online(ahead.robots[R0]) and told(ahead)[0] == "age unknown"
    state = reduced(ahead, pose(T0 + 0.6, stamp=SITE + 3600.6), tick(T0 + 0.7))
    assert state.is_online(state.robots[R0]) and age(state) < 0.2
    little = seen(BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5), pose(T0, stamp=SITE + 2.0))
    assert little.is_online(little.robots[R0])


def test_other_robots_have_the_clock_of_the_site() -> None:
    others = [pose(T0 - 1 + n / 10, stamp=SITE - 1 + n / 10, robot="robot_1") for n in range(9)]
    state = seen(*others, pose(T0, stamp=SITE - 40.0), robots=2)
    assert round(age(state), 1) == 40.5 and told(state)[0] == "offline 40 s"


def test_a_first_stamp_that_nothing_dates_is_of_unknown_age() -> None:
    state = seen(pose(T0, stamp=SITE - 40.0))
    robot = state.robots[R0]
    assert not state.is_online(robot) and not state.is_fresh(robot, "pose")
    assert told(state)[0] == "age unknown" and "age unknown" in asked(state)
    assert "robot_0: age unknown" in attention(state)
    assert report(state)["robots"][0]["pose"]["age_s"] is None
    assert reasons(state, robot)[0].name == "age unknown"
    alarmed = reduced(state, tick(T0 + 9))
    assert [alarm.text for alarm in alarmed.alarms] == ["age unknown"], "none came since"


def test_the_second_message_tells_the_age() -> None:
    state = seen(pose(T0, stamp=SITE - 40.0), pose(T0 + 0.1, stamp=SITE - 39.9))
    assert round(age(state), 1) == 0.4 and state.is_online(state.robots[R0])


def test_a_latched_stamp_and_then_a_live_one() -> None:
    state = seen(pose(T0, stamp=SITE - 40.0), pose(T0 + 0.1, stamp=SITE + 0.1))
    assert round(age(state), 1) == 0.4 and state.is_online(state.robots[R0])


def test_a_clock_that_runs_is_trusted_though_it_is_off() -> None:
    site = BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5)
    state = seen(site, pose(T0, stamp=SITE - 7200.0), pose(T0 + 0.1, stamp=SITE - 7199.9))
    assert round(age(state), 1) == 0.4 and state.is_online(state.robots[R0])


def test_a_robot_that_repeats_an_old_stamp_is_there_and_its_pose_is_old() -> None:
    site = BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5)
    state = seen(site, *(pose(T0 + n / 10, stamp=SITE - 40.0) for n in range(4)))
    assert state.is_online(state.robots[R0]) and round(age(state), 1) == 40.5
    assert told(state) == ["pose 40 s old"]


def test_a_late_bridge_makes_no_first_stamps_new() -> None:
    """The robots' clocks are those of the site: only the bridge delays them, by 9 s."""
    site = BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5)
    late = BridgeAnswered(LINK, T0 - 0.1, 9.0)
    state = reduced(fleet(), link_up(T0 - 20), site, late, tick(T0 - 0.05))
    poses = [pose(T0 + n / 10, stamp=SITE + n / 10 - 9.0) for n in range(4)]
    state = reduced(state, *poses, tick(T0 + 0.5))
    assert round(age(state), 1) == 9.2


def test_a_localised_pose_is_as_old_as_its_stamp_at_first_sight() -> None:
    site = BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5)
    event = LocalisationReported(R0, T0, Pose(1.0, 2.0), F0, SITE - 40.0, None)
    state = seen(site, event)
    located = state.robots[R0].located_at
    assert located is not None and round(T0 - located) == 40
    assert round(age(state)) == 40, "nothing else tells its time"


def test_the_first_word_of_a_driver_that_nothing_dates_is_no_sign_of_life() -> None:
    event = MemberReported(R0, T0, Pose(1.0, 2.0), F0, SITE - 40.0, None, "", "")
    state = seen(event)
    assert state.robots[R0].last_received is None
    dated = seen(BridgeAnswered(LINK, T0 - 0.5, 0.004, SITE - 0.5), event)
    assert dated.robots[R0].last_received == T0 - 40.0


@pytest.mark.parametrize("factor", [0.25, 0.5, 1.0, 2.0])
@pytest.mark.parametrize("lag", [0.004, 0.3])
def test_simulated_time_at_any_pace_makes_no_robot_old(factor: float, lag: float) -> None:
    state = reduced(fleet(2), link_up(T0))
    for n in range(600):
        at = T0 + n / 10
        stamp = SITE + (at - T0) * factor
        stands = pose(at, stamp=min(stamp, SITE + 30.0 * factor), robot="robot_1")
        answer = [BridgeAnswered(LINK, at, lag, stamp - lag * factor)] * (n % 20 == 0)
        state = reduced(state, *answer, pose(at, x=n / 10, stamp=stamp), stands, tick(at))
        if n >= 60:
            assert age(state) < 0.4 and state.is_fresh(state.robots[R0], "pose")
            assert state.is_online(state.robots[R0])
            assert late_link(state, state.links[LINK]) is None and silent(state, state.robots[R0]) is None
    assert not any(alarm.key[0] == R0 for alarm in state.alarms if alarm.holds)
    assert state.is_old(state.robots["robot_1"], "pose")


def test_a_site_whose_clock_is_set_back_makes_no_old_stamp_new() -> None:
    """The clock of the bridge's machine alone: the robot repeats a pose of before."""
    state = reduced(fleet(), link_up(T0))
    for n in range(400):
        at = T0 + n / 10
        stamp = SITE + at - T0
        told_by_site = stamp - 18_000.0 * (n >= 200)
        answer = [BridgeAnswered(LINK, at, 0.004, told_by_site - 0.004)] * (n % 20 == 0)
        state = reduced(state, *answer, pose(at, stamp=min(stamp, SITE + 10.0)), tick(at))
    assert 25.0 < age(state) <= 31.0 and state.is_old(state.robots[R0], "pose")


def test_a_slow_answer_does_not_move_the_clock_of_a_site() -> None:
    answers = [BridgeAnswered(LINK, T0 + 2 * n, 0.004, SITE + 2 * n) for n in range(9)]
    slow = BridgeAnswered(LINK, T0 + 18.0, 0.45, SITE + 17.56)
    link = reduced(fleet(), link_up(T0 - 1), *answers, slow).links[LINK]
    assert link.clock == T0 - SITE and link.drift == 0.0


def test_a_pace_is_not_believed_for_hours_after_the_last_answer() -> None:
    answers = BridgeAnswered(LINK, T0, 0.4, SITE - 0.4), BridgeAnswered(LINK, T0 + 2, 0.004, SITE + 2)
    at = 36_000.0
    state = reduced(fleet(), link_up(T0 - 1), *answers, pose(T0 + at, stamp=SITE + at), tick(T0 + at))
    assert age(state) < 3.0


def test_slow_time_that_passed_while_the_link_was_down_makes_no_robot_old() -> None:
    state = reduced(fleet(), link_up(T0))
    for n in range(300):
        at = T0 + n / 10 + (60.0 if n >= 150 else 0.0)
        stamp = SITE + (at - T0) / 2
        if n == 150:
            state = reduced(state, link_lost(at - 59.0), link_up(at - 0.1))
        answer = [BridgeAnswered(LINK, at, 0.004, stamp - 0.002)] * (n % 20 == 11)
        state = reduced(state, pose(at, stamp=stamp), *answer, tick(at))
    assert age(state) < 1.0 and state.is_fresh(state.robots[R0], "pose")
