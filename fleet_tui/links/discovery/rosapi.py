"""The queries of rosapi. Only lists, and queries of listed names: some other queries crash rosapi of ROS 2
for all clients."""

import asyncio
import time
from collections.abc import Awaitable, Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

import msgspec

from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.robots.ros.messages import TimeAnswer
from fleet_tui.text.errors import LinkError

T = TypeVar("T")

ANSWER_WITHIN = 2.0
AT_ONCE_ROS1 = 8
"""Questions open at once: a bridge has a thread for each. On ROS 2, where four have killed rosapi, and before
the version is known they are two."""


def _nothing() -> None:
    """Ignore progress."""


async def look_around(wire: BridgeConnection, asks_node: bool = False) -> RosapiFacts:
    """List the topics, services and nodes of a bridge, and detect its ROS version. `asks_node`: if rosapi
    does not answer, the bridge's own node is asked."""
    try:
        topics, version = await _both(wire, "topics", "get_ros_version")
        services, nodes = await _both(wire, "services", "nodes")
    except LinkError:
        problem = wire.lost or f"no reply from rosapi within {ANSWER_WITHIN:g} s"
        return RosapiFacts(
            problem=problem, is_bridge_mute=asks_node and not wire.lost and await wire.is_mute(ANSWER_WITHIN)
        )
    if not isinstance(topics, dict):
        return RosapiFacts(problem=str(topics))
    types = dict(zip(_names(topics, "topics"), _names(topics, "types"), strict=False))
    ros = _ros(version, types)
    if ros == 1:
        wire.places = asyncio.Semaphore(AT_ONCE_ROS1)
    return RosapiFacts(
        types,
        dict.fromkeys(_names(services, "services")),
        tuple(_names(nodes, "nodes")),
        actions=await _actions(wire) if ros == 2 else (),
        ros=ros,
        distro=str(version.get("distro", "")) if isinstance(version, dict) else "",
    )


async def _both(wire: BridgeConnection, one: str, other: str) -> tuple[object, object]:
    """Ask rosapi two questions at once. Raises LinkError."""
    first, second = (wire.call(f"/rosapi/{name}", {}, ANSWER_WITHIN) for name in (one, other))
    return await asyncio.gather(first, second)


async def _actions(wire: BridgeConnection) -> tuple[str, ...]:
    """Return the names of action servers, which are neither in topics nor in services."""
    answer = await _ask(wire, "action_servers", {}, "action_servers", time.monotonic() + ANSWER_WITHIN)
    return tuple(map(str, answer)) if isinstance(answer, list) else ()


def _ros(version: object, types: Mapping[str, str]) -> int:
    """Return 1 or 2: an old rosapi does not report it, but only ROS 2 spells types with `/msg/`."""
    answered = version.get("version") if isinstance(version, dict) else None
    return answered if answered in (1, 2) else 2 if any("/msg/" in type_ for type_ in types.values()) else 1


async def clock_ahead(wire: BridgeConnection) -> float | None:
    """Return the seconds by which the bridge's clock is ahead of ours, None if unknown."""
    began, wall = time.monotonic(), time.time()
    try:
        answer = await wire.call("/rosapi/get_time", {}, ANSWER_WITHIN)
        answered = msgspec.convert(answer, TimeAnswer).time.seconds
    except (LinkError, msgspec.ValidationError):
        return None
    return None if answered is None else answered - (wall + (time.monotonic() - began) / 2)


async def _ask(wire: BridgeConnection, verb: str, args: dict[str, object], key: str, until: float) -> Any:
    """Return one field of an answer, None without an answer, or a place at rosapi in time."""
    async with wire.places:
        if time.monotonic() > until:
            return None
        try:
            answer = await wire.call(f"/rosapi/{verb}", args, min(ANSWER_WITHIN, until - time.monotonic()))
        except LinkError:
            return None
    return answer.get(key) if isinstance(answer, dict) else None


async def ask_publishers(
    wire: BridgeConnection,
    rosapi: RosapiFacts,
    topics: Iterable[str],
    until: float,
    asked: Callable[[], object] = _nothing,
) -> RosapiFacts:
    """Add the publishers of these topics, as far as time allows until the monotonic `until`; `asked` is
    called after each."""

    async def publishers_of(topic: str) -> tuple[str, ...] | None:
        nodes = await _ask(wire, "publishers", {"topic": topic}, "publishers", until)
        return tuple(map(str, nodes)) if isinstance(nodes, list) else None

    there = [topic for topic in topics if topic in rosapi.topics]
    found = await _each(publishers_of, there, asked)
    return replace(rosapi, publishers={**rosapi.publishers, **found})


async def subscribers(wire: BridgeConnection, topic: str, until: float) -> list[str]:
    """Return the nodes that are subscribed to a topic."""
    nodes = await _ask(wire, "subscribers", {"topic": topic}, "subscribers", until)
    return [str(node) for node in nodes] if isinstance(nodes, list) else []


async def ask_subscribers(
    wire: BridgeConnection, rosapi: RosapiFacts, topics: Iterable[str], until: float
) -> RosapiFacts:
    """Add the subscribers of these topics, as far as time allows; none of one that does not exist."""

    async def subscribers_of(topic: str) -> tuple[str, ...] | None:
        nodes = await _ask(wire, "subscribers", {"topic": topic}, "subscribers", until)
        return tuple(map(str, nodes)) if isinstance(nodes, list) else None

    topics = list(topics)
    absent = {topic: () for topic in topics if topic not in rosapi.topics}
    found = await _each(subscribers_of, [topic for topic in topics if topic not in absent])
    return replace(rosapi, subscribers={**rosapi.subscribers, **absent, **found})


async def ask_services(
    wire: BridgeConnection, rosapi: RosapiFacts, services: Iterable[str], until: float
) -> RosapiFacts:
    """Add the types of these services, then their nodes, as far as time allows."""
    there = [service for service in services if service in rosapi.services]

    async def node_of(service: str) -> str:
        return str(await _ask(wire, "service_node", {"service": service}, "node", until) or "")

    rosapi = await ask_service_types(wire, rosapi, there, until)
    return replace(rosapi, owners=await _each(node_of, there))


async def ask_service_types(
    wire: BridgeConnection,
    rosapi: RosapiFacts,
    services: Iterable[str],
    until: float,
    asked: Callable[[], object] = _nothing,
) -> RosapiFacts:
    """Add the types of these services, as far as time allows; `asked` is called after each."""

    async def type_of(service: str) -> str:
        return str(await _ask(wire, "service_type", {"service": service}, "type", until) or "")

    types = await _each(type_of, [one for one in services if one in rosapi.services], asked)
    return replace(rosapi, services={**rosapi.services, **types})


def _names(answer: object, key: str) -> list[str]:
    found: Any = answer.get(key) if isinstance(answer, dict) else None
    return [str(name) for name in found] if isinstance(found, list) else []


async def _each(
    ask: Callable[[str], Awaitable[T | None]], names: list[str], asked: Callable[[], object] = _nothing
) -> dict[str, T]:
    """Return the answers that arrive in time."""

    async def one(name: str) -> T | None:
        answer = await ask(name)
        asked()
        return answer

    answers = await asyncio.gather(*map(one, names))
    return {name: answer for name, answer in zip(names, answers, strict=True) if answer is not None}
