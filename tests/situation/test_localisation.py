"""An uncertain localisation, and what is usual after a pose was set by hand."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import Baseline, CommandRecord, Stage, Step
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading
from fleet_tui.model.set_up.commands import SetPose
from fleet_tui.rules.alarms.navigation import not_sure_where
from fleet_tui.situation.localisation import SETTLES_IN, uncertain
from tests.support.fleets import F0, R0, T0, WALL, fleet, pose, reduced, tick

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
