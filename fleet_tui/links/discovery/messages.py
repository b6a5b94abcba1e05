"""Messages of topics whose messages alone name robots."""

import asyncio
import time
from collections.abc import Iterable, Mapping
from contextlib import suppress
from functools import partial

from fleet_tui.links.discovery.wire import BridgeConnection, TopicListening
from fleet_tui.model.events import Event
from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.registry import KINDS
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.operations import Subscription
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import LinkError

WITHIN = 2.5
"""Seconds in which each fleet sends its state."""
MOST = 200
"""Messages of a topic that are kept."""


async def sample_messages(
    wire: BridgeConnection, types: Mapping[str, str], until: float
) -> dict[str, tuple[object, ...]]:
    """Return the messages of some seconds by topic, of the topics that exist with their usual types. Without
    such a topic it takes no time."""
    found: dict[str, list[object]] = {}
    for kind in KINDS.values():
        for key in kind.samples:
            topic, type_ = kind.vocabulary.topics[key]
            if same_type(types.get(topic, ""), type_):
                found[topic] = []
    if not found:
        return {}
    with suppress(LinkError):
        for topic, kept in found.items():
            wire.listening[topic] = TopicListening(_feed(topic), time.monotonic(), partial(_keep, kept))
            wire.connection.send(operations.subscribe(Subscription(topic, types[topic], queue_length=MOST)))
        await asyncio.sleep(min(WITHIN, max(0.0, until - time.monotonic())))
        for topic in found:
            wire.unsubscribe(topic)
            del wire.listening[topic]
    return {topic: tuple(kept) for topic, kept in found.items()}


def _feed(topic: str) -> Feed:
    return Feed("", ("",), "", topic, "")


def _keep(kept: list[object], _feed: Feed, msg: object, _at: float) -> Iterable[Event]:
    if len(kept) < MOST:
        kept.append(msg)
    return ()
