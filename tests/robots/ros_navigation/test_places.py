"""Places that orders lead to: with a heading of their own, else with that of the way there."""

import math

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.robots.ros_navigation.places import pose_of_stop, stamped
from fleet_tui.text.errors import CommandError
from tests.support.nav2_adapter import robot


def test_a_vertex_is_where_its_graph_has_it_with_the_heading_of_the_way_there() -> None:
    assert pose_of_stop(robot(), Stop("2"), Pose(1.0, -4.0)) == Pose(1.0, 0.0, math.pi / 2)


def test_who_is_there_already_keeps_its_heading_and_without_a_place_there_is_none() -> None:
    assert pose_of_stop(robot(), Stop("2"), Pose(1.05, 0.0, 2.0)) == Pose(1.0, 0.0, 2.0)
    assert pose_of_stop(robot(), Stop("2"), None) == Pose(1.0, 0.0)


def test_a_pose_has_its_own_heading() -> None:
    assert pose_of_stop(robot(), Stop(pose=Pose(7.0, 8.0, 1.0)), Pose(0.0, 0.0)) == Pose(7.0, 8.0, 1.0)


def test_a_vertex_that_no_graph_has_is_named() -> None:
    with pytest.raises(CommandError, match="position of vertex 77 unknown"):
        pose_of_stop(robot(), Stop("77"), None)


def test_a_pose_on_the_wire_has_the_frame_of_the_map_and_no_stamp() -> None:
    message = stamped(Pose(1.0, 2.0, math.pi))
    assert message["header"] == {"frame_id": "map"}
    assert message["pose"] == {
        "position": {"x": 1.0, "y": 2.0, "z": 0.0},
        "orientation": {"x": 0.0, "y": 0.0, "z": 1.0, "w": pytest.approx(0.0)},
    }
