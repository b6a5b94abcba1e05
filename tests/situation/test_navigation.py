"""Servers of a navigation that are not active, and what they wait for."""

import pytest
from msgspec.structs import replace

from fleet_tui.cli.status.report import attention
from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import DOWN, Servers
from fleet_tui.model.navigation_events import ServersReported
from fleet_tui.model.robot import Logged
from fleet_tui.robots.nav2.adapter import SERVERS_SILENCE
from fleet_tui.situation.navigation import inactive, inactive_cause
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.news import in_cells, news, shortened_news
from tests.support.fleets import R0, T0, WALL, reduced
from tests.support.nav2_goals import localised, nav2, odometry, unheard

KILLED = Servers(False, "controller_server", DOWN)


def asked(servers: Servers, seconds: int, first: int = 0) -> FleetState:
    """A robot whose servers told for so many seconds the same."""
    state = nav2()
    for second in range(first, first + seconds + 1):
        at = T0 + second
        spoke = odometry(at), localised(at, 0.0), ServersReported(R0, at, servers)
        state = reduced(state, *spoke, TimePassed(at, WALL + at))
    return state


def test_a_node_that_is_down_is_told_everywhere_in_the_same_words() -> None:
    state = asked(KILLED, 12)
    robot = state.robots[R0]
    fact = inactive(state, robot)
    assert fact is not None and fact.text == "Nav2 inactive: controller_server down"
    assert [text for text, _ in news(state, robot)] == [fact.text]
    (alarm,) = [one.condition for one in state.alarms if one.holds]
    assert (alarm.text, alarm.kind, alarm.remedy) == (fact.text, "navigation", fact.action)
    why = reasons(state, robot)[0]
    assert (why.name, why.remedy) == (
        fact.text,
        "Start controller_server again, then all of Nav2: see its log",
    )
    assert f"{R0}: {fact.text}" in attention(state)


def test_it_needs_a_look_at_once_and_is_an_alarm_only_after_a_start_takes() -> None:
    state = asked(KILLED, 3)
    assert not [one for one in state.alarms if one.holds]
    assert f"{R0}: Nav2 inactive: controller_server down" in attention(state)


@pytest.mark.parametrize(
    ("servers", "is_counted", "is_placed", "cause"),
    [
        (KILLED, False, False, "controller_server down"),
        (Servers(False, "planner_server", "activating"), False, False, "no odometry"),
        (Servers(False, "planner_server", "activating"), True, False, "no pose yet: set one"),
        (Servers(False, "planner_server", "activating"), True, True, "planner_server activating"),
        (Servers(False), True, True, "paused or not started"),
    ],
)
def test_the_first_cause_is_told(servers: Servers, is_counted: bool, is_placed: bool, cause: str) -> None:
    assert inactive_cause(servers, is_counted, is_placed)[0] == cause


def test_what_was_told_long_ago_means_nothing_now() -> None:
    state = asked(KILLED, 3)
    later = T0 + 3 + SERVERS_SILENCE + 1
    state = reduced(state, odometry(later), TimePassed(later, WALL + later))
    assert inactive(state, state.robots[R0]) is None


def test_the_log_tells_of_a_dead_node_where_the_last_answer_is_old() -> None:
    state = asked(Servers(True), 3)
    later = T0 + 3 + SERVERS_SILENCE + 1
    state = reduced(state, odometry(later), TimePassed(later, WALL + later))
    line = Logged(Message("CRITICAL FAILURE: SERVER bt_navigator IS DOWN"), later)
    fact = inactive(state, replace(state.robots[R0], logged=(line,)))
    assert fact is not None and fact.text == "Nav2 inactive: bt_navigator down"
    assert fact.evidence == "the log of its lifecycle manager says so"


def test_it_is_over_with_the_next_answer() -> None:
    state = asked(KILLED, 12)
    at = T0 + 13
    state = reduced(state, odometry(at), ServersReported(R0, at, Servers(True)), TimePassed(at, WALL + at))
    assert inactive(state, state.robots[R0]) is None
    silent = replace(state.robots[R0], servers=None)
    assert inactive(state, silent) is None


def test_a_missing_pose_is_one_alarm_with_what_waits_for_it() -> None:
    state, servers = unheard(), Servers(False, "planner_server", "activating")
    for second in range(20):
        at = T0 + second
        state = reduced(state, odometry(at), ServersReported(R0, at, servers), TimePassed(at, WALL + at))
    assert [one.text for one in state.alarms if one.holds] == ["Nav2 inactive: no pose yet: set one"]
    told = list(news(state, state.robots[R0]))
    assert shortened_news(told, 24)[0][0] == "no pose yet: set one"


def test_a_cause_that_would_be_cut_gives_way_to_what_it_causes() -> None:
    state = asked(KILLED, 12)
    told = shortened_news(list(news(state, state.robots[R0])), 18)
    assert "".join(text for text, _ in in_cells(told, 18)).strip() == "Nav2 inactive…"
