"""Listening to the topics of a bridge together, over as many connections as that takes."""

import asyncio
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress

from fleet_tui.config.schema import Link
from fleet_tui.errors import LinkError
from fleet_tui.headless.doctor.facts import TopicFacts, is_hidden
from fleet_tui.headless.doctor.wire import Wire
from fleet_tui.link.subscriptions import Wanted
from fleet_tui.rosbridge.type_names import same_type

CONNECT_WITHIN = 4.0
# Seconds that topics are listened to, at least and at most: a little longer than a robot may be silent
# for and still be online.
AT_LEAST, AT_MOST = 1.5, 6.0
BATCH = 20  # subscribes, of which a real bridge needs 20 ms for each
SHARE = 150  # topics of one connection, 3 s of subscribing; the bridge works on several side by side
ENOUGH = 3  # messages of a topic to tell its rate; poses are the fast ones
ENOUGH_FAST = 10

Asked = list[tuple[Wanted, str]]


async def listen(
    bridge: Link, wanted: list[Wanted], types: Mapping[str, str], until: float, drawn: Iterable[str] = ()
) -> tuple[list[TopicFacts], str]:
    """Listen to all topics together until each has said enough, or the time is over; with them why a
    connection was lost meanwhile. `drawn`: floors whose live map nobody needs."""
    asked = list(_worth_hearing(wanted, types, drawn))
    count = -(-len(asked) // SHARE)
    wires = [Wire(bridge) for _ in range(count)]
    try:
        await asyncio.gather(*(_hear(wire, asked[n::count], until) for n, wire in enumerate(wires)))
        now = time.monotonic()
        heard = {topic: one.facts(now) for wire in wires for topic, one in wire.heard.items()}
        lost = next((wire.lost for wire in wires if wire.lost), "")
    finally:
        for wire in wires:
            wire.close()
    return [heard.get(one.subscription.topic) or TopicFacts(one) for one in wanted], lost


def _worth_hearing(
    wanted: Iterable[Wanted], types: Mapping[str, str], drawn: Iterable[str]
) -> Iterator[tuple[Wanted, str]]:
    """What may be subscribed to, with the bridge's spelling of its type. With a wrong type, or before it
    is there, a topic would be spoiled for every client. Of a floor one live map is enough, and none where
    it is drawn already."""
    floors = set(drawn)
    for one in wanted:
        topic, type_ = one.subscription.topic, one.subscription.type
        if types and not is_hidden(topic) and not same_type(types.get(topic, ""), type_):
            continue
        if one.kind.heavy:
            if one.floor in floors:
                continue
            floors.add(one.floor)
        yield one, types.get(topic, type_)


async def _hear(wire: Wire, topics: Asked, until: float) -> None:
    if await wire.connect(min(CONNECT_WITHIN, until - time.monotonic())):
        return
    with suppress(LinkError):
        await _subscribe(wire, topics, until)
        began = time.monotonic()
        until = min(until, began + AT_MOST)
        while time.monotonic() < until and not wire.lost:
            await asyncio.sleep(0.05)
            enough = all(heard.count >= _enough(heard.wanted) for heard in wire.heard.values())
            if enough and time.monotonic() > began + AT_LEAST:
                break


async def _subscribe(wire: Wire, topics: Asked, until: float) -> None:
    """Subscribe, some at a time: a call is answered when the subscribes before it are done.

    Raises LinkError.
    """
    for first in range(0, len(topics), BATCH):
        batch = topics[first : first + BATCH]
        for one, type_ in batch:
            wire.subscribe(one, type_)
        await wire.beat(max(0.1, until - time.monotonic()))
        for one, _ in batch:
            wire.heard[one.subscription.topic].since = time.monotonic()


def _enough(wanted: Wanted) -> int:
    return 1 if wanted.kind.per_floor else ENOUGH_FAST if wanted.kind.fast else ENOUGH
