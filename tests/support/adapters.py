"""Adapters as tests ask them: by the key of a topic."""

from fleet_tui.model.events import Event
from fleet_tui.robots.adapter import Adapter, Feed, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS, kind_of
from fleet_tui.robots.ros.names import Names


def adapter_of(profile: Profile | None = None) -> Adapter:
    profile = profile or Profile()
    return KINDS[kind_of(profile)].adapter(profile, Site())


def names_of(profile: Profile | None = None) -> Names:
    return adapter_of(profile).names


def feed_of(adapter: Adapter, key: str, robot: str, floor: str) -> Feed:
    topic = adapter.names.topic(key, robot, floor) or f"/{key}"
    known = {feed.key: feed for feed in adapter.feeds(robot, [floor])}
    return known.get(key) or Feed(key, (robot,), floor, topic, adapter.names.type(key))


def event_of(adapter: Adapter, key: str, msg: object, robot: str, floor: str, at: float) -> Event:
    """The one fact that a message tells."""
    (event,) = adapter.read(feed_of(adapter, key, robot, floor), msg, at)
    return event
