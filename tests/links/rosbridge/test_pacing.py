"""A large fleet's topics come as often as their robots are looked at; the truth about them stays."""

from collections.abc import AsyncIterator

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Alarms, Config
from fleet_tui.links.rosbridge import subscriber
from fleet_tui.links.rosbridge.pacing import SHARE
from fleet_tui.model.attention import Attention, Rates, SeenArea
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import SubscriptionsAdvanced
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import finished, linked, ready
from tests.support.watched_store import config_of

ROBOTS = 6
RATES = Rates(full_up_to=3, changes_per_s=1000)
LATCHED = ("graph", "labeled_vertices", "map_metadata")


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(OhFleet(robots=ROBOTS, floors=1, seed=1, quiet=True))
    await running.start()
    yield running
    await running.stop()


def large(server: RosbridgeServer, rates: Rates = RATES) -> Config:
    return replace(config_of(server.url, ROBOTS), rates=rates)


def asked(server: RosbridgeServer, topic: str) -> list[int]:
    """The throttle rates with which a topic was subscribed, in their order."""
    return [
        one["throttle_rate"]
        for one in server.bridge.received
        if one["op"] == "subscribe" and one["topic"] == topic
    ]


async def test_who_is_selected_comes_fully_and_the_others_seldom(server: RosbridgeServer) -> None:
    async with linked(large(server)) as (_, store):
        store.attention = Attention("robot_0")
        await store.until(ready)
        assert asked(server, "/robot_1/pose") == [RATES.pose_ms]
        assert asked(server, "/robot_1/battery") == [RATES.status_ms]
        store.attention = Attention("robot_1")
        await store.until(lambda _: len(asked(server, "/robot_1/battery")) == 2)
        assert asked(server, "/robot_1/pose") == [RATES.pose_ms, 100]
        assert asked(server, "/robot_1/battery") == [RATES.status_ms, 500]
        assert asked(server, "/robot_2/pose") == [RATES.pose_ms]
        # One subscription replaces the other: with two the bridge would take the faster one for ever.
        ids = {one["id"] for one in server.bridge.received if one.get("topic") == "/robot_1/pose"}
        assert len(ids) == 1
        assert not [one for one in server.bridge.received if one["op"] == "unsubscribe"]
        for name in LATCHED:  # they would be sent again
            assert len(asked(server, f"/robot_1/floor_0/{name}")) == 1


async def test_who_is_in_view_comes_as_often_as_the_zoom_can_show(server: RosbridgeServer) -> None:
    async with linked(large(server)) as (_, store):
        store.attention = Attention("robot_0")
        await store.until(ready)
        store.attention = Attention("robot_0", "floor_0", SeenArea(-1e3, -1e3, 1e3, 1e3, 0.4))
        await store.until(
            lambda _: all(len(asked(server, f"/robot_{n}/pose")) == 2 for n in range(1, ROBOTS))
        )
        assert asked(server, "/robot_3/pose")[-1] == 200
        assert asked(server, "/robot_3/battery") == [RATES.status_ms]


async def test_a_command_is_confirmed_at_the_full_rate(server: RosbridgeServer) -> None:
    async with linked(large(server)) as (link, store):
        store.attention = Attention("robot_0")
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_4"))
    assert record.stage is Stage.CONFIRMED
    assert asked(server, "/robot_4/paused")[:2] == [RATES.status_ms, 500]


async def test_a_small_fleet_is_subscribed_once_at_its_own_rates(server: RosbridgeServer) -> None:
    async with linked(large(server, Rates(full_up_to=ROBOTS))) as (_, store):
        store.attention = Attention("robot_1")
        state = await store.until(ready)
        await store.until(lambda now: now.now > state.now + 1.0)
        assert asked(server, "/robot_1/pose") == asked(server, "/robot_2/pose") == [100]
        assert asked(server, "/robot_2/battery") == [500]


async def test_no_rate_is_so_slow_that_a_robot_looks_offline(server: RosbridgeServer) -> None:
    config = replace(large(server, replace(RATES, pose_ms=60_000)), alarms=Alarms(offline_after=2.0))
    # A pose that may be old for long is a sign of life all the same.
    config = replace(config, profile=replace(config.profile, silence={"pose": 60.0}))
    async with linked(config) as (_, store):
        store.attention = Attention("robot_0")
        await store.until(ready)
        assert asked(server, "/robot_2/pose") == [int(2000 * SHARE)]


async def test_no_rate_is_so_slow_that_a_command_looks_without_effect(server: RosbridgeServer) -> None:
    config = replace(large(server), alarms=Alarms(not_confirmed_after=1.5))
    async with linked(config) as (_, store):
        store.attention = Attention("robot_0")
        await store.until(ready)
        assert asked(server, "/robot_1/pose") == [int(1500 * SHARE)]


async def test_a_large_start_goes_by_attention_and_tells_how_far_it_is(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(subscriber, "AT_ONCE", 10)
    async with linked(large(server)) as (_, store):
        store.attention = Attention("robot_5")
        await store.until(ready)
        topics = [one["topic"] for one in server.bridge.received if one["op"] == "subscribe"]
        assert all(topic.startswith("/robot_5/") for topic in topics[:9])
        assert topics[9:14] == [f"/robot_{n}/pose" for n in range(5)]
        await store.until(lambda state: state.links["rosbridge"].topics)
        await store.until(lambda state: not state.links["rosbridge"].waiting_topics)
    done = [one.done for one in store.told(SubscriptionsAdvanced) if isinstance(one, SubscriptionsAdvanced)]
    assert done == [0, 10, 20, 30, 40, 50, 54]


async def test_a_bridge_that_answers_no_call_gets_all_subscriptions_at_once(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(subscriber, "AT_ONCE", 10)
    monkeypatch.setattr(subscriber, "OWN_WORD", "/rosapi/get_time")
    server.bridge.services.silent_services.add("/rosapi/get_time")
    async with linked(large(server)) as (_, store):
        await store.until(lambda state: all(robot.pose for robot in state.robots.values()))
        await store.until(lambda state: state.links["rosbridge"].topics)
        await store.until(lambda state: not state.links["rosbridge"].waiting_topics)
    done = [one.done for one in store.told(SubscriptionsAdvanced) if isinstance(one, SubscriptionsAdvanced)]
    assert done == [0, 10, 54]
