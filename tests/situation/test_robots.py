"""Facts about robots."""

import math

from fleet_tui.cli.status.report import attention
from fleet_tui.cli.status.status import ATTENTION, verdict
from fleet_tui.commands.checks import problems
from fleet_tui.model.events import MessageRejected, ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation_events import BlockedReported
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.news import news
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    fleet,
    link_up,
    of_kinds,
    place_order,
    pose,
    queue,
    reduced,
    text_of,
    tick,
)

ON_CHANGE = Kind("nav2", silence={"blocked": math.inf})
BAD = Message("/robot_0/battery: percentage is missing")


def sends_only_bad_data(seconds: float) -> FleetState:
    """A robot that was well, and whose every message is bad from T0 on."""
    state = reduced(fleet(), link_up(T0 - 60), battery(T0), tick(T0))
    for n in range(round(seconds * 2)):
        state = reduced(state, tick(T0 + n / 2), MessageRejected(R0, BAD))
    return reduced(state, tick(T0 + seconds))


def test_a_robot_whose_messages_all_are_bad_reads_so() -> None:
    state = sends_only_bad_data(20.0)
    robot = state.robots[R0]
    assert next(news(state, robot)) == ("bad data x40", StyleRole.ALARM)
    assert "offline" not in text_of(fleet_table(state, R0, 120).rows[0].runs)
    (alarm,) = state.alarms
    assert alarm.condition.kind == "data" and alarm.text.startswith(
        "all messages are bad, 40 so far: /robot_0"
    )
    assert "power" not in action_of(alarm.condition)
    found = reasons(state, robot)[0]
    assert found.name == "bad data x40" and BAD in found.evidence and "power" not in found.remedy
    assert [line for line in attention(state) if "bad" in line] == [f"robot_0: {alarm.text}"]
    asked = problems(state, Request((place_order(R0, 1, 2),)), Permissions())
    assert [one.text for one in asked if one.check == "bad data"] == [
        f"no message of robot_0 is readable: {BAD}"
    ]


def test_one_that_sends_nothing_more_is_offline() -> None:
    state = reduced(sends_only_bad_data(20.0), tick(T0 + 30.0), tick(T0 + 31.0))
    assert next(news(state, state.robots[R0]))[0] == "offline 12 s"
    assert {alarm.condition.kind for alarm in state.alarms if alarm.holds} == {"offline"}


def test_some_bad_data_of_a_robot_that_speaks_is_told_beside() -> None:
    state = reduced(sends_only_bad_data(20.0), battery(T0 + 20.5), tick(T0 + 21.0))
    assert "offline" not in {alarm.condition.kind for alarm in state.alarms}
    assert ("bad data x40", StyleRole.WARN) in list(news(state, state.robots[R0]))


def in_contact_for(seconds: float) -> FleetState:
    at = T0 + 10
    facts = (pose(at), battery(at), queue(at), ObstacleReported(R0, at, seconds))
    return reduced(fleet(), link_up(T0), *facts, tick(at + 0.1))


def test_contact_of_three_seconds_is_red_and_counted_but_no_alarm_yet() -> None:
    state = in_contact_for(3.2)
    assert not state.alarms
    assert ("obstacle 3.2 s", StyleRole.ALARM) in list(news(state, state.robots[R0]))
    (robot,) = floor_scene(state, Selection(R0, F0)).robots
    assert robot.alarmed and robot.obstacle
    assert "1 robot blocked by an obstacle: robot_0" in attention(state) and verdict(state) == ATTENTION


def stopped_for(seconds: float) -> FleetState:
    """A robot whose collision monitor stopped it, and reports on change only."""
    at = T0 + 10
    state = reduced(
        of_kinds(fleet(), *(ON_CHANGE for _ in fleet().robots)),
        link_up(T0),
        pose(at),
        BlockedReported(R0, at, "stop", "front"),
    )
    return reduced(state, pose(at + seconds), battery(at + seconds), tick(at + seconds))


def test_a_stop_by_the_collision_monitor_is_contact_with_an_obstacle() -> None:
    state = stopped_for(3.2)
    assert not state.alarms
    assert ("blocked 3.2 s (seen)", StyleRole.ALARM) in list(news(state, state.robots[R0]))
    (robot,) = floor_scene(state, Selection(R0, F0)).robots
    assert robot.alarmed and robot.obstacle
    assert "1 robot blocked by an obstacle: robot_0" in attention(state) and verdict(state) == ATTENTION


def test_a_passing_stop_is_nothing_and_a_long_one_an_alarm() -> None:
    state = stopped_for(2.0)
    assert not any("obstacle" in line for line in attention(state))
    assert not any("blocked" in text for text, _ in news(state, state.robots[R0]))
    (robot,) = floor_scene(state, Selection(R0, F0)).robots
    assert not robot.alarmed and not robot.obstacle
    assert [alarm.text for alarm in stopped_for(31.0).alarms] == ["blocked 31 s (seen)"]


def test_an_obstacle_at_last_report_raises_no_alarm_of_a_silent_robot() -> None:
    state = reduced(in_contact_for(20.0), tick(T0 + 40))
    assert {alarm.condition.kind for alarm in state.alarms} == {"offline"}
    state = reduced(in_contact_for(31.0), tick(T0 + 40))
    assert {alarm.condition.kind for alarm in state.alarms if alarm.holds} == {"obstacle", "offline"}


def test_a_passing_contact_is_nothing_and_a_long_one_an_alarm() -> None:
    state = in_contact_for(2.0)
    assert not any("obstacle" in line for line in attention(state))
    (robot,) = floor_scene(state, Selection(R0, F0)).robots
    assert not robot.alarmed and not robot.obstacle
    state = in_contact_for(31.0)
    assert [alarm.text for alarm in state.alarms] == ["obstacle 31 s"]
