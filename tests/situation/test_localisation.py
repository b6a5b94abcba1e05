"""An uncertain localisation, and what is usual after a pose was set by hand."""

import pytest

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import CommandAdvanced, Event, TopicNotAllowed, TopicsDropped
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import LocalisationReported
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.situation.alarms.navigation import not_sure_where
from fleet_tui.situation.localisation import no_pose, uncertain
from fleet_tui.situation.navigation import NO_ODOMETRY
from fleet_tui.state.command_events import COMMANDS_KEPT
from fleet_tui.state.navigation_reports import SETTLES_IN
from tests.support.fleets import F0, LINK, R0, T0, battery, commanded, reduced, tick
from tests.support.nav2_goals import localised, nav2, odometry


@pytest.mark.parametrize(
    ("event", "is_bridge"),
    [
        (TopicsDropped(LINK, (R0,)), True),
        (TopicNotAllowed(LINK, "/robot_0/odom", (R0,)), True),
        (TopicNotAllowed(LINK, "/robot_0/battery", (R0,)), False),
        (TopicsDropped(LINK, ("robot_1",)), False),
    ],
)
def test_odometry_that_only_the_bridge_misses_is_mended_at_the_bridge(event: Event, is_bridge: bool) -> None:
    at = T0 + 7.0
    placed = reduced(nav2(), odometry(T0), localised(T0, 0.0), odometry(T0 + 1.0))
    state = reduced(placed, battery(at, 50.0), event, tick(at))
    fact = no_pose(state, state.robots[R0])
    assert fact is not None and (fact.action != NO_ODOMETRY) is is_bridge, fact


def set_at(at: float, id_: int = 1) -> tuple[Event, ...]:
    return commanded(id_, SetPose(R0, F0, Pose(0.0, 0.0)), Stage.SENT, at=at)


def reported(at: float, variance: float, stamp: float | None = None) -> LocalisationReported:
    return LocalisationReported(R0, at, Pose(0.0, 0.0), "map", at if stamp is None else stamp, variance)


def is_lost(state: FleetState) -> bool:
    robot = state.robots[R0]
    assert (uncertain(robot) is None) is (not_sure_where(state, robot, {}) is None)
    return uncertain(robot) is not None


def standing(*events: Event) -> FleetState:
    """A robot that stands for an hour after these events."""
    state = reduced(nav2(), *events)
    return reduced(state, odometry(T0 + 3600.0), tick(T0 + 3600.0))


@pytest.mark.parametrize(
    ("variance", "after", "alarms"),
    [
        (0.52, 0.0, False),
        (0.52, 1.0, False),  # about what RViz and this console send with a pose
        (0.52, SETTLES_IN + 1.0, True),
        (4.0, 1.0, True),
    ],
)
def test_what_was_set_here_is_no_alarm_however_long_the_robot_stands(
    variance: float, after: float, alarms: bool
) -> None:
    assert is_lost(standing(*set_at(T0), reported(T0 + after, variance))) is alarms


def test_what_was_reported_before_a_pose_was_set_stays_until_the_next_report() -> None:
    state = standing(reported(T0, 0.52), *set_at(T0 + 1.0))
    assert is_lost(state)
    assert not is_lost(reduced(standing(reported(T0, 4.0), *set_at(T0 + 1.0)), reported(T0 + 1.1, 0.52)))


def test_a_second_set_pose_raises_no_alarm_until_its_report_comes() -> None:
    assert not is_lost(standing(*set_at(T0), reported(T0 + 1.0, 0.52), *set_at(T0 + 60.0, 2)))


def test_the_latched_report_of_a_set_pose_is_no_alarm_when_a_new_connection_brings_it_again() -> None:
    state = standing(*set_at(T0), reported(T0 + 1.0, 0.52))
    assert not is_lost(reduced(state, reported(T0 + 3600.0, 0.52, stamp=T0 + 1.0)))
    assert is_lost(reduced(state, reported(T0 + 3600.0, 0.52)))


def test_a_set_pose_is_remembered_behind_however_many_commands() -> None:
    confirmed = CommandAdvanced(1, Stage.ACCEPTED, T0), CommandAdvanced(1, Stage.CONFIRMED, T0)
    state = standing(*set_at(T0), *confirmed, reported(T0 + 1.0, 0.52))
    for n in range(2, COMMANDS_KEPT + 3):
        state = reduced(state, *commanded(n, PauseRobot("robot_1"), Stage.SENT, Stage.REFUSED))
    assert not [one for one in state.commands if isinstance(one.command, SetPose)]
    assert not is_lost(state)
