"""Remedies name the tools of the ROS that is there."""

import pytest

from fleet_tui.links.discovery.tools import LOOK_FOR_NODE, named


@pytest.mark.parametrize(
    ("ros", "words"),
    [(1, "rosnode ping /base"), (2, "ros2 node list"), (0, "rosnode ping /base, ROS 2: ros2 node list")],
)
def test_a_remedy_names_the_tools_of_the_ros_that_is_there(ros: int, words: str) -> None:
    assert named(LOOK_FOR_NODE, ros, "/base") == words
