"""A robot's belief of its pose."""

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.senses.belief import Belief

TRUE = Pose(1.0, 2.0, 0.3)


def test_it_is_right_until_it_is_misplaced() -> None:
    belief = Belief()
    assert belief.of(TRUE) == TRUE
    belief.place(Pose(5.0, 2.0, 0.3), TRUE)
    assert belief.of(TRUE) == Pose(5.0, 2.0, 0.3)


def test_near_the_truth_it_is_found() -> None:
    belief = Belief()
    belief.place(Pose(5.0, 2.0, 0.3), TRUE)
    belief.place(Pose(1.3, 2.0, 0.4), TRUE)
    assert belief.misplaced is None


def test_it_moves_as_the_robot_does() -> None:
    belief = Belief()
    belief.place(Pose(5.0, 2.0, TRUE.yaw), TRUE)
    belief.carry(TRUE, Pose(1.5, 2.0, 0.3))
    moved = belief.of(TRUE)
    assert (round(moved.x, 6), round(moved.y, 6)) == (5.5, 2.0)
