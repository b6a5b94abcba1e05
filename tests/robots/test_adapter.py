"""The feeds of every kind: their robots, and those that come only on demand."""

import pytest

from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS


def test_a_feed_of_several_robots_is_listed_with_the_first() -> None:
    feed = Feed("map", ("robot_0", "robot_1"), "hall", "/map", "nav_msgs/OccupancyGrid", wanted_for="map")
    assert (feed.robot, feed.on_demand, feed._replace(wanted_for="").on_demand) == ("robot_0", True, False)


@pytest.mark.parametrize("kind", KINDS)
def test_large_feeds_come_on_demand_and_no_topic_is_asked_for_twice(kind: str) -> None:
    feeds = list(KINDS[kind].adapter(Profile(kind=kind), Site()).feeds("robot_0", ("hall", "yard")))
    assert feeds and all(feed.robot == "robot_0" for feed in feeds)
    assert all(feed.on_demand for feed in feeds if feed.large)
    addresses = [(feed.address, feed.floor) for feed in feeds]
    assert len(set(addresses)) == len(addresses)
