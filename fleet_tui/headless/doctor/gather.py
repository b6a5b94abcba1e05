"""Everything that a bridge which answers tells: round trips, rosapi, and what comes on its topics."""

import asyncio
import time

from fleet_tui.adapters import KINDS
from fleet_tui.adapters.ros.type_names import same_type
from fleet_tui.adapters.subscriptions import Wanted, wanted_topics
from fleet_tui.config.profile import SERVICES
from fleet_tui.config.schema import Config
from fleet_tui.errors import LinkError
from fleet_tui.headless.doctor.facts import BridgeFacts, Rosapi
from fleet_tui.headless.doctor.listening import listen
from fleet_tui.headless.doctor.rosapi import (
    ANSWER_WITHIN,
    ask_publishers,
    ask_services,
    clock_ahead,
    look_around,
)
from fleet_tui.headless.doctor.wire import Wire

ROUND_TRIPS = 10
BETWEEN = 0.05  # seconds between two of them while all topics come


async def measure_calls(wire: Wire, until: float, pause: float = 0.0) -> tuple[float, ...]:
    """Round trips to the bridge itself in seconds, one after the other."""
    trips = list[float]()
    until = min(until, time.monotonic() + ANSWER_WITHIN)
    while len(trips) < ROUND_TRIPS and time.monotonic() < until:
        began = time.monotonic()
        try:
            await wire.beat(max(0.1, until - time.monotonic()))
        except LinkError:
            # The first one that is not answered has taken at least as long.
            if wire.lost or trips:
                break
        trips.append(time.monotonic() - began)
        await asyncio.sleep(pause)
    return tuple(trips)


def asked_topics(config: Config, link: str) -> list[Wanted]:
    """Every topic of a bridge's robots."""
    return list(wanted_topics(config, KINDS[config.profile.name](config.profile), link))


async def _look_up(config: Config, name: str, wire: Wire, rosapi: Rosapi, until: float) -> Rosapi:
    """Ask rosapi about the topics and services of a bridge's robots."""
    wanted = asked_topics(config, name)
    named = [one.subscription.topic for one in wanted]
    robots = [robot.name for robot in config.robots if robot.link == name]
    services = [config.profile.service(key, robot) for robot in robots for key in SERVICES]
    rosapi = await ask_publishers(wire, rosapi, named, until)
    rosapi = await ask_services(wire, rosapi, services, until)
    if all(map(rosapi.has, named)):
        return rosapi
    # One of the same type may be what was meant.
    expected = {one.subscription.type for one in wanted}
    others = [
        topic
        for topic, type_ in rosapi.topics.items()
        if topic not in rosapi.publishers and any(same_type(type_, one) for one in expected)
    ]
    return await ask_publishers(wire, rosapi, others, until)


async def gather(config: Config, name: str, wire: Wire, until: float) -> BridgeFacts:
    """Everything about a bridge that answers, by the monotonic `until`: questions and topics side by side."""
    trips = await measure_calls(wire, until)
    rosapi, ahead = await look_around(wire), None
    drawn = [floor.name for floor in config.floors if floor.map]
    wanted = asked_topics(config, name)
    listening = asyncio.ensure_future(listen(config.bridge(name), wanted, rosapi, until, drawn))
    if not rosapi.problem:
        ahead = await clock_ahead(wire)
        rosapi = await _look_up(config, name, wire, rosapi, until)
    busy = () if listening.done() else await measure_calls(wire, until, BETWEEN)
    heard = await listening
    lost = wire.lost or heard.lost
    return BridgeFacts(name, rosapi, tuple(heard.topics), trips, ahead, lost, busy, heard.behind)
