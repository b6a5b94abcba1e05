"""Profiles of simulated robots of the source's stack, against the topics they have."""

from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1


def test_every_topic_of_the_profile_is_one_of_theirs() -> None:
    fleet = OhFleet(1, 2)
    names = {topic.name for topic in fleet.topics(0.0, ROS1)} | set(fleet.subscriptions())
    for floors in (1, 2):
        topics = KINDS["oh_ressources"].profile(floors)["topics"].values()
        assert {topic.format(robot="robot_0", floor="floor_0") for topic in topics} <= names
