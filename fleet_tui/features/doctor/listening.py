"""Subscribes to the topics of a bridge together, over as many connections as needed."""

import asyncio
import time
from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.facts import RosapiFacts, TopicFacts
from fleet_tui.links.discovery.rosapi import ask_subscribers, subscribers
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros.names import is_hidden
from fleet_tui.robots.ros.reading import ROSOUT
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import LinkError

CONNECT_WITHIN = 4.0
CHECK_EVERY = 0.05  # seconds
# Minimum and maximum seconds of listening to topics: a little longer than a robot may be silent
# and still be online.
AT_LEAST = 1.5
AT_MOST = 6.0
BATCH = 20  # subscriptions, of which a real bridge needs 20 ms for each
SHARE = 150  # topics of one connection, 3 s of subscribing; the bridge handles several in parallel
ENOUGH = 3  # messages of a topic for its rate; poses are the frequent ones
ENOUGH_FAST = 10
# Seconds after which a floor's topic is unsubscribed, and for how long, so that the bridge forgets its
# QoS; and the number of them whose subscribers are queried meanwhile.
FIRST_TRY = 2.0
RELEASE_TIME = 0.7
MOST_HELD = 20

# Seconds between two questions beside the messages: a bridge logs each as an error.
BEAT_EVERY = 0.5

Asked = list[tuple[Feed, str]]


class ListeningResult(NamedTuple):
    """All topics, the reason that a connection was lost meanwhile, our own maximum delay, and the round trips
    of questions that waited beside the messages, in seconds."""

    topics: list[TopicFacts]
    lost: str
    behind: float
    trips: tuple[float, ...] = ()
    barred: frozenset[str] = frozenset()
    """Services that the bridge does not allow, by its log."""
    subscribers: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    """The nodes subscribed to each silent topic while we were."""


async def listen(
    bridge: Link,
    adapters: Mapping[str, Adapter],
    wanted: list[Feed],
    rosapi: RosapiFacts,
    until: float,
    drawn: Iterable[str] = (),
    places: asyncio.Semaphore | None = None,
) -> ListeningResult:
    """Listen to all topics together until each has enough messages, or the time limit has passed. `adapters`
    by robot; `drawn`: floors whose live map is not needed; `places` as for BridgeConnection."""
    asked = list(_to_subscribe(wanted, rosapi, drawn))
    count = -(-len(asked) // SHARE)
    wires = [BridgeConnection(bridge, adapters, places) for _ in range(count)]
    trips = list[float]()
    try:
        heard_by = await asyncio.gather(
            *(_listen(wire, asked[n::count], rosapi, until, trips) for n, wire in enumerate(wires))
        )
        now = time.monotonic()
        received = {topic: one.facts(now) for wire in wires for topic, one in wire.listening.items()}
        complaints = {topic: message for wire in wires for topic, message in wire.complaints.items()}
        lost = next((wire.lost for wire in wires if wire.lost), "")
    finally:
        for wire in wires:
            wire.close()
    found = (received.get(one.address) or TopicFacts(one) for one in wanted)
    topics = [replace(one, complaint=complaints.get(one.topic, "")) for one in found]
    behind = max((wire.behind for wire in wires), default=0.0)
    barred = frozenset(service for wire in wires for service in wire.barred)
    return ListeningResult(topics, lost, behind, tuple(trips), barred, dict(ChainMap(*heard_by)))


def _to_subscribe(
    wanted: Iterable[Feed], rosapi: RosapiFacts, drawn: Iterable[str]
) -> Iterator[tuple[Feed, str]]:
    """Return the topics to subscribe to, with the bridge's spelling of the type. A wrong type, or a topic
    that does not exist yet, would make it unusable for every client. Of a floor one live map is enough,
    and none if it has a map file."""
    floors, types = set(drawn), rosapi.topics
    for one in wanted:
        topic, type_ = one.address, one.type
        if rosapi.lacks_action_of(topic):
            continue
        if types and not is_hidden(topic) and not same_type(types.get(topic, ""), type_):
            continue
        if one.large:
            if one.floor in floors:
                continue
            floors.add(one.floor)
        yield one, types.get(topic, type_)


async def _listen(
    wire: BridgeConnection, topics: Asked, rosapi: RosapiFacts, until: float, trips: list[float]
) -> dict[str, tuple[str, ...]]:
    """Listen over one connection, and return the subscribers of its silent topics."""
    if await wire.connect(min(CONNECT_WITHIN, until - time.monotonic())):
        return {}
    with suppress(LinkError):
        if ROSOUT in rosapi.topics:
            wire.subscribe_logs(rosapi.topics[ROSOUT])
        began = time.monotonic()
        try:
            await _subscribe(wire, topics, rosapi.ros != 1, until)
        except LinkError:
            if not wire.lost:  # it answers the call behind the subscriptions too late
                trips.append(time.monotonic() - began)
            raise
        ours = min(until, time.monotonic() + AT_MOST)
        retry = asyncio.ensure_future(_retry_silent(wire, topics, rosapi, ours))
        beats = asyncio.ensure_future(_beat(wire, until, trips))
        try:
            await _wait(wire, [one for one, _ in topics], ours)
        finally:
            beats.cancel()
            await asyncio.gather(beats, return_exceptions=True)
        await retry
        return await _subscribers(wire, topics, rosapi, until)
    return {}


async def _subscribers(
    wire: BridgeConnection, topics: Asked, rosapi: RosapiFacts, until: float
) -> dict[str, tuple[str, ...]]:
    """Return the nodes that ROS knows to be subscribed to silent topics. A bridge of ROS 1 whose master was
    restarted is none of them, for as long as any client holds the topic."""
    if rosapi.problem or rosapi.ros != 1:
        return {}
    silent = [one.address for one, _ in topics if _is_silent(wire, one) and not _may_wait(one)]
    there = [topic for topic in silent[:MOST_HELD] if topic in rosapi.topics]
    return dict((await ask_subscribers(wire, replace(rosapi, subscribers={}), there, until)).subscribers)


async def _beat(wire: BridgeConnection, until: float, trips: list[float]) -> None:
    """Measure how long questions wait beside the messages, and add each to `trips`. The bridge has answered
    one behind the subscriptions: one without an answer has taken at least as long."""
    with suppress(LinkError):
        while True:
            began = time.monotonic()
            try:
                await wire.beat(max(0.1, until - began))
            finally:
                trips.append(time.monotonic() - began)
            await asyncio.sleep(BEAT_EVERY)


async def _wait(wire: BridgeConnection, topics: list[Feed], until: float) -> None:
    least = time.monotonic() + AT_LEAST
    while time.monotonic() < until and not wire.lost:
        asleep = time.monotonic()
        await asyncio.sleep(CHECK_EVERY)
        wire.behind = max(wire.behind, time.monotonic() - asleep - CHECK_EVERY)
        enough = all(
            wire.listening[one.address].count >= _enough(one) for one in topics if not _may_wait(one)
        )
        if enough and time.monotonic() > least:
            return


async def _subscribe(wire: BridgeConnection, topics: Asked, latched: bool, until: float) -> None:
    """Subscribe in batches: a call is answered when the subscriptions before it are done.

    Raises LinkError.
    """
    for first in range(0, len(topics), BATCH):
        batch = topics[first : first + BATCH]
        for one, type_ in batch:
            wire.subscribe(one, type_, latched and one.latched)
        await wire.beat(max(0.1, until - time.monotonic()))
        for one, _ in batch:
            wire.listening[one.address].since = time.monotonic()


async def _retry_silent(wire: BridgeConnection, topics: Asked, rosapi: RosapiFacts, until: float) -> None:
    """Subscribe with default options to a floor's silent topics, to find the reason. Raises LinkError.

    A bridge of ROS 2 chooses the QoS once, for all its clients, and sends nothing binary that is larger than
    its limit.
    """
    if rosapi.ros == 1 or until - time.monotonic() < 2 * FIRST_TRY:
        return
    floors = [(one, type_) for one, type_ in topics if one.latched and not _may_wait(one)]
    await _wait(wire, [one for one, _ in floors], time.monotonic() + FIRST_TRY)
    silent = [(one, type_) for one, type_ in floors if _is_silent(wire, one)]
    if not silent:
        return
    for one, _ in silent:
        wire.unsubscribe(one.address)
    await asyncio.sleep(RELEASE_TIME)
    for one, _ in silent[:MOST_HELD] if not rosapi.problem else ():
        topic = one.address
        holders = await subscribers(wire, topic, until)
        wire.listening[topic].held_by = next((node for node in holders if "rosbridge" in node), "")
    for one, type_ in silent:
        wire.subscribe_plainly(one, type_)
    await _wait(wire, [one for one, _ in silent], until)


def _is_silent(wire: BridgeConnection, wanted: Feed) -> bool:
    received = wire.listening[wanted.address]
    return not received.count and not received.fragmented


def _may_wait(wanted: Feed) -> bool:
    """Tell whether silence is normal: before a change, or before a goal is given."""
    return wanted.silent and (not wanted.latched or is_hidden(wanted.address))


def _enough(wanted: Feed) -> int:
    return 1 if wanted.latched else ENOUGH_FAST if wanted.fast else ENOUGH
