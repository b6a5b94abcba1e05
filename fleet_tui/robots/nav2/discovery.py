"""Robots with Nav2, recognised by their action servers, else by services or topics that only they have."""

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.robots.ros_navigation.discovery import found_at, namespaces, of_robots

DRIVES = ("navigate_to_pose", "navigate_through_poses", "follow_waypoints")
IS_ACTIVE = VOCABULARY.services["is_active"][0].replace("/{robot}", "")
ONE_BY_ONE = ("odometry", "pose", "battery", "blocked")
"""Topics of one robot."""


def discover(listed: Listed) -> Discovery:
    """Recognise these robots among the names that a bridge lists."""
    spaces = _namespaces(listed)
    return found_at(spaces, ONE_BY_ONE, VOCABULARY, listed)


def _namespaces(listed: Listed) -> list[str]:
    """Return the namespaces of robots without a leading slash; empty for a robot alone on its bridge."""
    by_action = namespaces(listed.actions, DRIVES)
    by_service = namespaces(listed.services, [IS_ACTIVE[1:]])
    by_topic = _with(listed, "pose") & _with(listed, "odometry")
    return of_robots(by_action or by_service or by_topic)


def _with(listed: Listed, key: str) -> set[str]:
    """Return the namespaces with a topic of this name and type. On ROS 1 the same names are another
    kind's."""
    name, type_ = VOCABULARY.topics[key]
    there = [topic for topic, other in listed.topics.items() if "/msg/" in other and same_type(other, type_)]
    return namespaces(there, [name.rpartition("/")[2]])
