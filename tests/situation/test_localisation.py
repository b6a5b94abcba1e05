"""An uncertain localisation, and what is usual after a pose was set by hand."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Baseline, CommandRecord, Stage, Step
from fleet_tui.model.events import Event, TopicNotAllowed, TopicsDropped
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.rules.alarms.navigation import not_sure_where
from fleet_tui.situation.localisation import SETTLES_IN, no_pose, uncertain
from fleet_tui.situation.navigation import NO_ODOMETRY
from tests.support.fleets import F0, LINK, R0, T0, WALL, battery, fleet, pose, reduced, tick
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


SET = CommandRecord(
    1, SetPose(R0, F0, Pose(0.0, 0.0)), T0, WALL, (Step(Stage.CHECKED, T0), Step(Stage.SENT, T0)), Baseline()
)


@pytest.mark.parametrize(
    ("variance", "after", "is_lost"),
    [
        (0.52, 1.0, False),  # about what RViz and this console send with a pose
        (0.52, SETTLES_IN + 1.0, True),
        (0.52, -1.0, True),
        (4.0, 1.0, True),
    ],
)
def test_what_was_set_here_is_no_alarm_however_long_the_robot_stands(
    variance: float, after: float, is_lost: bool
) -> None:
    state = replace(reduced(fleet(), pose(T0), tick(T0 + 3600.0)), commands=(SET,))
    robot = replace(
        state.robots[R0], variance=Reading(variance, T0 + after), pose=Reading(Pose(0.0, 0.0), T0 + 3600.0)
    )
    assert (uncertain(state, robot) is not None) is is_lost
    assert (not_sure_where(state, robot, {}) is not None) is is_lost
