"""What a bridge that answers tells: rosapi, round trips, and what comes on its topics."""

import asyncio
import time
from collections.abc import Awaitable, Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any, TypeVar

import msgspec

from fleet_tui.config.profile import SERVICES
from fleet_tui.config.schema import Config
from fleet_tui.errors import LinkError
from fleet_tui.headless.doctor.facts import BridgeFacts, Rosapi, TopicFacts
from fleet_tui.headless.doctor.wire import Wire
from fleet_tui.link.subscriptions import Wanted, plain_type, wanted_topics
from fleet_tui.robots import KINDS
from fleet_tui.rosbridge.messages import Stamp

T = TypeVar("T")

ANSWER_WITHIN = 2.0
AT_ONCE = 8  # calls under way together: the bridge has a thread for each
ROUND_TRIPS = 10
# Seconds that topics are listened to, at least and at most: a little longer than a robot may be silent
# for and still be online.
AT_LEAST, AT_MOST = 1.5, 6.0
BATCH = 20  # subscribes, of which a real bridge needs 20 ms for each
ENOUGH = 3  # messages of a topic to tell its rate; poses are the fast ones
ENOUGH_FAST = 10


class _Time(msgspec.Struct):
    """What /rosapi/get_time answers."""

    time: Stamp


async def ask_rosapi(wire: Wire, wanted: Sequence[Wanted], services: Iterable[str], until: float) -> Rosapi:
    """List what there is, and ask more about these topics and services; by the monotonic `until`."""
    try:
        first, second, third = await asyncio.gather(
            *(wire.call(name, {}, ANSWER_WITHIN) for name in ("topics", "services", "nodes"))
        )
    except LinkError:
        return Rosapi(problem=wire.lost or f"rosapi does not answer within {ANSWER_WITHIN:g} s")
    if not isinstance(first, dict):
        return Rosapi(problem=str(first))
    types = dict(zip(_names(first, "topics"), _names(first, "types"), strict=False))
    there = dict.fromkeys(_names(second, "services"), "")

    async def publishers_of(topic: str) -> tuple[str, ...] | None:
        answer = await wire.call("publishers", {"topic": topic}, ANSWER_WITHIN)
        return tuple(_names(answer, "publishers")) if isinstance(answer, dict) else None

    async def type_of(service: str) -> str | None:
        answer = await wire.call("service_type", {"service": service}, ANSWER_WITHIN)
        return str(answer.get("type", "")) if isinstance(answer, dict) else None

    publishers = await _each(publishers_of, _of_interest(types, wanted), until)
    there |= await _each(type_of, [service for service in services if service in there], until)
    return Rosapi(types, there, tuple(_names(third, "nodes")), publishers)


def _of_interest(types: Mapping[str, str], wanted: Sequence[Wanted]) -> list[str]:
    """The topics that are wanted, then those of the same types: one may be what was meant."""
    expected = {plain_type(one.subscription.type) for one in wanted}
    named = {one.subscription.topic: None for one in wanted}
    others = [topic for topic, type_ in types.items() if plain_type(type_) in expected]
    return [topic for topic in dict.fromkeys([*named, *others]) if topic in types]


def _names(answer: object, key: str) -> list[str]:
    found: Any = answer.get(key) if isinstance(answer, dict) else None
    return [str(name) for name in found] if isinstance(found, list) else []


async def _each(ask: Callable[[str], Awaitable[T | None]], names: list[str], until: float) -> dict[str, T]:
    """The answers that come in time, a few asked at once."""
    free = asyncio.Semaphore(AT_ONCE)
    answers: dict[str, T] = {}

    async def one(name: str) -> None:
        async with free:
            if time.monotonic() > until:
                return
            try:
                answer = await ask(name)
            except LinkError:
                return
            if answer is not None:
                answers[name] = answer

    await asyncio.gather(*(one(name) for name in names))
    return answers


def _clock(answer: object) -> float | None:
    try:
        return msgspec.convert(answer, _Time).time.seconds
    except msgspec.ValidationError:
        return None


async def measure_calls(wire: Wire) -> tuple[tuple[float, ...], float | None]:
    """Round trips in seconds, one after the other, and by how much the bridge's clock is ahead of ours."""
    trips, ahead = list[float](), None
    until = time.monotonic() + ANSWER_WITHIN
    while len(trips) < ROUND_TRIPS and time.monotonic() < until:
        began, wall = time.monotonic(), time.time()
        try:
            answer = await wire.call("get_time", {}, ANSWER_WITHIN)
        except LinkError:
            break
        trips.append(time.monotonic() - began)
        seconds = _clock(answer)
        if seconds is not None:
            ahead = seconds - (wall + trips[-1] / 2)
    return tuple(trips), ahead


def asked_topics(config: Config, link: str) -> list[Wanted]:
    """Every topic of a bridge's robots."""
    return list(wanted_topics(config, KINDS[config.profile.name](config.profile), link))


def _worth_hearing(
    wanted: Iterable[Wanted], types: Mapping[str, str], drawn: Iterable[str]
) -> Iterator[tuple[Wanted, str]]:
    """What may be subscribed to, with the bridge's spelling of its type. With a wrong type, or before it
    is there, a topic would be spoiled for every client. Of a floor one live map is enough, and none where
    it is drawn already."""
    floors = set(drawn)
    for one in wanted:
        topic, type_ = one.subscription.topic, one.subscription.type
        if types and plain_type(types.get(topic, "")) != plain_type(type_):
            continue
        if one.kind.heavy:
            if one.floor in floors:
                continue
            floors.add(one.floor)
        yield one, types.get(topic, type_)


async def listen(
    wire: Wire, wanted: list[Wanted], types: Mapping[str, str], until: float, drawn: Iterable[str] = ()
) -> list[TopicFacts]:
    """Listen to all topics together until each has said enough, or the time is over. `drawn`: floors whose
    live map nobody needs."""
    with suppress(LinkError):
        await _subscribe(wire, list(_worth_hearing(wanted, types, drawn)), until)
        began = time.monotonic()
        until = min(until, began + AT_MOST)
        while time.monotonic() < until and not wire.lost:
            await asyncio.sleep(0.05)
            enough = all(heard.count >= _enough(heard.wanted) for heard in wire.heard.values())
            if enough and time.monotonic() > began + AT_LEAST:
                break
    now = time.monotonic()
    heard = {topic: one.facts(now) for topic, one in wire.heard.items()}
    return [heard.get(one.subscription.topic) or TopicFacts(one) for one in wanted]


async def _subscribe(wire: Wire, topics: list[tuple[Wanted, str]], until: float) -> None:
    """Subscribe, some at a time: a call is answered when the subscribes before it are done.

    Raises LinkError.
    """
    for first in range(0, len(topics), BATCH):
        batch = topics[first : first + BATCH]
        for one, type_ in batch:
            wire.subscribe(one, type_)
        await wire.call("get_time", {}, max(0.1, until - time.monotonic()))
        for one, _ in batch:
            wire.heard[one.subscription.topic].since = time.monotonic()


def _enough(wanted: Wanted) -> int:
    return 1 if wanted.kind.per_floor else ENOUGH_FAST if wanted.kind.fast else ENOUGH


async def gather(config: Config, name: str, wire: Wire, until: float) -> BridgeFacts:
    """Everything about a bridge that answers, by the monotonic `until`."""
    wanted = asked_topics(config, name)
    services = [
        config.profile.service(key, robot.name)
        for robot in config.robots
        if robot.link == name
        for key in SERVICES
    ]
    trips, ahead = await measure_calls(wire)
    half = time.monotonic() + (until - time.monotonic()) / 3
    rosapi = await ask_rosapi(wire, wanted, services, half)
    drawn = [floor.name for floor in config.floors if floor.map]
    topics = await listen(wire, wanted, rosapi.topics, until, drawn)
    return BridgeFacts(name, rosapi, tuple(topics), trips, ahead, wire.lost)
