"""The adapter of fleets: shared topics that are neither throttled nor shortened."""

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of, shared_topics
from fleet_tui.config.schema import Config
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.rmf.adapter import Rmf
from tests.support.rmf import adapter

TWO = Config(
    floors=[FloorEntry("L1")],
    robots=[RobotEntry("tiny/t1"), RobotEntry("carrier/c1")],
    profile=Profile(name="rmf"),
)


def test_no_shared_topic_is_throttled_or_keeps_only_the_newest() -> None:
    feeds = list(adapter().feeds("tiny/t1", ["L1"]))
    assert {feed.key for feed in feeds} >= {"fleets", "statuses", "tasks"}
    for feed in (one for one in feeds if not one.has_pictures):
        assert (feed.rate_ms, feed.queue_length, feed.is_shared) == (0, 100, True)


def test_robots_of_a_link_share_one_subscription_for_each_topic() -> None:
    adapters = adapters_of(TWO)
    assert not list(shared_topics(TWO, adapters))
    feeds = feeds_of(TWO, adapters, "rosbridge")
    assert len({feed.address for feed in feeds}) == len(feeds)
    assert all(feed.robots == ("tiny/t1", "carrier/c1") for feed in feeds)


def test_a_topic_that_a_site_lacks_costs_its_values() -> None:
    kind = Rmf(Profile(kind="rmf", topics={"tasks": ""}), Site()).kind
    assert "queue" not in kind.reports and "pose" in kind.reports
