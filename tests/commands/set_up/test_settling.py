"""Refinement of a pose: when it is enough, and how its effect is said."""

import pytest
from msgspec.structs import replace

from fleet_tui.commands.set_up.settling import is_settled, pose_since, settling_text
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading
from tests.support.fleets import R0, T0, fleet

A, B, NEAR = Pose(0.0, 0.0), Pose(0.3, 0.4, 0.1), Pose(0.3, 0.41, 0.11)


def test_only_a_pose_since_the_call_counts() -> None:
    robot = replace(fleet().robots[R0], pose=Reading(A, T0))
    assert pose_since(robot, T0 - 1) == A and pose_since(robot, T0) is None


@pytest.mark.parametrize(
    ("poses", "settled", "text"),
    [
        ((A, A), True, "1 call, pose changed by 0.00 m and 0°"),
        ((A, B), False, "1 call, pose changed by 0.50 m and 6°"),
        ((A, B, NEAR), True, "2 calls, pose changed by 0.51 m and 6°, by 0.01 m and 1° at the last"),
        ((A, B, A), False, "2 calls, pose changed by 0.00 m and 0°, still by 0.50 m and 6° at the last"),
        ((A, None), False, "1 call, no pose reported since"),
        ((None, B), False, "1 call, pose reported"),
        ((A, Pose(0.0, 0.0, 0.1)), False, "1 call, pose changed by 0.00 m and 6°"),
    ],
)
def test_it_ends_when_a_call_changes_nothing(
    poses: tuple[Pose | None, ...], settled: bool, text: str
) -> None:
    assert (is_settled(poses), settling_text(poses)) == (settled, text)
