"""Listening to topics together: until each has said enough, and never with a type that would spoil one."""

import asyncio
import time

import pytest

from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Link
from fleet_tui.features.doctor import listening
from fleet_tui.features.doctor.listening import ListeningResult, listen
from fleet_tui.links.discovery.facts import RosapiFacts, TopicFacts
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.robots.adapter import Feed
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 2)
ADAPTERS = adapters_of(CONFIG)
FEEDS: list[Feed] = feeds_of(CONFIG, ADAPTERS, "rosbridge")


async def listened(
    url: str, types: dict[str, str] | None = None, seconds: float = 60.0, drawn: tuple[str, ...] = ()
) -> tuple[dict[str, TopicFacts], ListeningResult]:
    rosapi = RosapiFacts({one.address: one.type for one in FEEDS} | (types or {}), ros=1)
    listening_ = listen(Link(url), ADAPTERS, FEEDS, rosapi, time.monotonic() + seconds, drawn)
    found = await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(listening_, network_loop()))
    return {one.topic: one for one in found.topics}, found


@pytest.fixture(autouse=True)
def quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(listening, "AT_LEAST", 0.1)


async def test_it_ends_when_each_topic_has_said_enough(server: RosbridgeServer) -> None:
    topics, found = await listened(server.url)
    assert not found.lost
    assert topics["/robot_0/pose"].count >= listening.ENOUGH_FAST
    assert topics["/robot_1/battery"].count >= listening.ENOUGH
    assert topics["/robot_0/floor_0/graph"].first_after is not None
    maps = [name for name, one in topics.items() if one.wanted.large and one.subscribed]
    assert maps == ["/robot_0/floor_0/map"]


async def test_a_wrong_type_is_not_subscribed_nor_a_map_that_is_drawn_from_a_file(
    server: RosbridgeServer,
) -> None:
    topics, _ = await listened(server.url, {"/robot_0/battery": "std_msgs/Int8"}, drawn=("floor_0",))
    asked = {one["topic"] for one in server.bridge.received if one["op"] == "subscribe"}
    assert not {"/robot_0/battery", "/robot_0/floor_0/map", "/robot_1/floor_0/map"} & asked
    assert not topics["/robot_0/battery"].subscribed and topics["/robot_1/battery"].count


async def test_many_topics_share_several_connections(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(listening, "SHARE", 4)
    topics, _ = await listened(server.url)
    assert all(one.count for one in topics.values() if not one.wanted.large)


async def test_a_silent_topic_costs_no_more_than_the_time(server: RosbridgeServer) -> None:
    server.bridge.muted.add("/robot_0/battery")
    topics, _ = await listened(server.url, seconds=1.0)
    silent = topics["/robot_0/battery"]
    assert silent.count == 0 and 0.5 < silent.waited < 3.0 and topics["/robot_0/pose"].count


async def test_a_bridge_that_is_not_there_leaves_every_topic_unheard() -> None:
    topics, found = await listened("ws://127.0.0.1:9", seconds=1.0)
    assert found.lost and not any(one.subscribed for one in topics.values())
