"""Facts of a bridge on which all is well, and topics of it that are not."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts, TopicFacts
from tests.support.fleets import LINK

NODE = "/driver"


def well(config: Config) -> BridgeFacts:
    """Every topic of a configuration's robots is published by a node of its robot, and heard."""
    adapters = adapters_of(config)
    feeds = feeds_of(config, adapters, LINK)
    topics = tuple(
        TopicFacts(one, True, waited=5.0, count=50, rate=10.0, first_after=0.1, age=0.1) for one in feeds
    )
    services = [one for robot, adapter in adapters.items() for one in adapter.services(robot)]
    rosapi = RosapiFacts(
        {one.address: one.type for one in feeds},
        {name: type_ for _, name, type_ in services},
        publishers={one.address: (f"/{one.robot}{NODE}",) for one in feeds},
        owners={name: NODE for _, name, _ in services},
        ros=1,
    )
    return BridgeFacts(LINK, rosapi, topics, round_trips=(0.01,), adapters=adapters)


def with_topics(facts: BridgeFacts, ends: tuple[str, ...], **changes: Any) -> BridgeFacts:
    """The same bridge, but for the topics with such ends."""
    changed = (replace(one, **changes) if one.topic.endswith(ends) else one for one in facts.topics)
    return replace(facts, topics=tuple(changed))


def mute(facts: BridgeFacts, *ends: str) -> BridgeFacts:
    """The same bridge, but nothing has come on the topics with such ends."""
    return with_topics(facts, ends, count=0, rate=None, age=None, first_after=None)


def with_rosapi(facts: BridgeFacts, **changes: Any) -> BridgeFacts:
    """The same bridge, but for what rosapi answers."""
    return replace(facts, rosapi=replace(facts.rosapi, **changes))


def without(named: Mapping[str, Any], *ends: str) -> dict[str, Any]:
    """The mapping without the names with these endings."""
    return {name: value for name, value in named.items() if not name.endswith(ends)}
