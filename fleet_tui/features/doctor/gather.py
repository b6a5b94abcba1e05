"""Facts of a bridge that answers: round trips, rosapi, and the messages of its topics."""

import asyncio
import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.listening import listen
from fleet_tui.links.discovery.facts import BridgeFacts, RosapiFacts
from fleet_tui.links.discovery.finding import nearest
from fleet_tui.links.discovery.rosapi import (
    ANSWER_WITHIN,
    ask_publishers,
    ask_service_types,
    ask_services,
    ask_subscribers,
    clock_ahead,
    look_around,
)
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.probes import LifecycleProbe, ListenerProbe, ServiceProbe
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import LinkError

ROUND_TRIPS = 10


async def measure_calls(wire: BridgeConnection, until: float) -> tuple[float, ...]:
    """Return round trips to the bridge itself in seconds, one after the other."""
    trips = list[float]()
    until = min(until, time.monotonic() + ANSWER_WITHIN)
    while len(trips) < ROUND_TRIPS and time.monotonic() < until:
        began = time.monotonic()
        try:
            await wire.beat(max(0.1, until - time.monotonic()))
        except LinkError:
            # The first unanswered one has taken at least as long.
            if wire.lost or trips:
                break
        trips.append(time.monotonic() - began)
    return tuple(trips)


async def _look_up(
    wanted: list[Feed],
    adapters: Mapping[str, Adapter],
    wire: BridgeConnection,
    rosapi: RosapiFacts,
    until: float,
) -> RosapiFacts:
    """Query rosapi about the topics and services of a bridge's robots."""
    named = [one.address for one in wanted]
    robots = dict.fromkeys(robot for one in wanted for robot in one.robots)
    services = [service for robot in robots for _, service, _ in adapters[robot].services(robot)]
    probes = [probe for robot in robots for probe in adapters[robot].probes(robot)]
    services += [one.service for one in probes if isinstance(one, LifecycleProbe | ServiceProbe)]
    rosapi = await ask_publishers(wire, rosapi, named, until)
    rosapi = await ask_services(wire, rosapi, services, until)
    # One that is near and of its type may be the intended one.
    near = {name for one in services if one not in rosapi.services for name in nearest(one, rosapi.services)}
    rosapi = await ask_service_types(wire, rosapi, near - {*services}, until)
    heard = [one.topic for one in probes if isinstance(one, ListenerProbe)]
    rosapi = await ask_subscribers(wire, rosapi, heard, until)
    if all(map(rosapi.has, named)):
        return rosapi
    # One of the same type may be the intended one.
    expected = {one.type for one in wanted}
    others = [
        topic
        for topic, type_ in rosapi.topics.items()
        if topic not in rosapi.publishers and any(same_type(type_, one) for one in expected)
    ]
    return await ask_publishers(wire, rosapi, others, until)


async def _ask_robots(
    wanted: list[Feed],
    adapters: Mapping[str, Adapter],
    wire: BridgeConnection,
    rosapi: RosapiFacts,
    until: float,
) -> dict[str, object]:
    """Call the services whose type is certain: on another type `{}` may be a command."""
    robots = dict.fromkeys(robot for one in wanted for robot in one.robots)
    probes = [probe for robot in robots for probe in adapters[robot].probes(robot)]
    lifecycles = [one for one in probes if isinstance(one, LifecycleProbe)]
    answers = await _answers([(one.service, one.type) for one in lifecycles], wire, rosapi, until)
    idle = [one for one in lifecycles if one.service in answers and not one.is_active(answers[one.service])]
    nodes = [
        (service, one.node_type)
        for one in idle
        for service in one.nodes.values()
        if service in rosapi.services
    ]
    if nodes:
        rosapi = await ask_services(wire, rosapi, [service for service, _ in nodes], until)
    return answers | await _answers(nodes, wire, rosapi, until)


async def _answers(
    asked: Iterable[tuple[str, str]], wire: BridgeConnection, rosapi: RosapiFacts, until: float
) -> dict[str, object]:
    """Call services, each given with its type."""

    async def answer(service: str) -> object:
        try:
            return await wire.call(service, {}, min(ANSWER_WITHIN, until - time.monotonic()))
        except LinkError:
            return f"no reply within {ANSWER_WITHIN:g} s"

    certain = [name for name, type_ in asked if same_type(rosapi.services.get(name) or "", type_)]
    called = certain if time.monotonic() < until else []
    return dict(zip(called, await asyncio.gather(*map(answer, called)), strict=True))


def _needed(feeds: Iterable[Feed], adapters: Mapping[str, Adapter], rosapi: RosapiFacts) -> Iterator[Feed]:
    """Leave out the transforms of robots whose localisation has a topic: the console asks for no others."""
    for feed in feeds:
        if feed.wanted_for != "place":
            yield feed
            continue
        lacking = [
            robot for robot in feed.robots if adapters[robot].names.topic("pose", robot) not in rosapi.topics
        ]
        if lacking:
            yield feed._replace(robots=tuple(lacking))


async def gather(config: Config, name: str, wire: BridgeConnection, until: float) -> BridgeFacts:
    """Gather everything about a bridge that answers, by the monotonic `until`: queries and topics in
    parallel."""
    trips = await measure_calls(wire, until)
    rosapi, ahead = await look_around(wire, asks_node=True), None
    drawn = [floor.name for floor in config.floors if floor.map]
    adapters = adapters_of(config)
    wanted = list(_needed(feeds_of(config, adapters, name), adapters, rosapi))
    listening = asyncio.ensure_future(
        listen(config.bridge(name), adapters, wanted, rosapi, until, drawn, wire.places)
    )
    if not rosapi.problem:
        ahead = await clock_ahead(wire)
        rosapi = await _look_up(wanted, adapters, wire, rosapi, until)
    answers = await _ask_robots(wanted, adapters, wire, rosapi, until)
    received = await listening
    rosapi = replace(rosapi, subscribers={**rosapi.subscribers, **received.subscribers})
    lost, busy = wire.lost or received.lost, received.trips
    return BridgeFacts(
        name,
        rosapi,
        tuple(received.topics),
        trips,
        ahead,
        lost,
        busy,
        received.behind,
        adapters,
        answers,
        received.barred,
    )
