"""A bridge of ROS 2: latched topics come whoever came first, large maps in pieces, its log is heard."""

import os
from collections.abc import AsyncIterator

import pytest

from fleet_tui.links.rosbridge import latched, subscriber
from fleet_tui.links.transports.rosbridge import connection
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import R0, place_order
from tests.support.links import finished, linked, phase, ready
from tests.support.nav2_site import LONG_AGO, Site
from tests.support.polling import HANGS
from tests.support.watched_store import WatchedStore, config_of

RESTARTS = int(os.environ.get("FLEET_TUI_RESTARTS", "3"))
LATCHED = ("graph", "labeled_vertices", "map_metadata", "map")


@pytest.fixture
async def server(monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[RosbridgeServer]:
    monkeypatch.setattr(connection, "FIRST_DELAY", 0.05)
    monkeypatch.setattr(connection, "LONGEST_DELAY", 0.2)
    server = RosbridgeServer(OhFleet(2, 1, seed=1, quiet=True), dialect=ROS2)
    await server.start()
    yield server
    await server.stop()


def counts(link: object, robots: int = 1) -> list[int]:
    from fleet_tui.links.fleet_link import FleetLink

    assert isinstance(link, FleetLink)
    topics = link.counters["rosbridge"].topics
    found = [topics[f"/robot_{n}/floor_0/{name}"].count for n in range(robots) for name in LATCHED[:3]]
    return [*found, topics["/robot_0/floor_0/map"].count]


async def came_again(link: object, store: WatchedStore, before: list[int]) -> None:
    await store.until(
        lambda _: all(now > then for now, then in zip(counts(link, 2), before, strict=True)), within=HANGS
    )


async def test_everything_latched_comes_after_each_restart_of_the_bridge(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        await came_again(link, store, [0] * 7)
        for _ in range(RESTARTS):
            before = counts(link, 2)
            await server.restart_bridge()
            await store.until(lambda state: not phase(Phase.UP)(state))
            await came_again(link, store, before)
        await store.until(lambda state: state.links["rosbridge"].command_path is CommandPath.ALIVE)
        record = await finished(link, store, place_order("robot_0", 0, 1))
        assert record.stage is Stage.CONFIRMED


async def test_a_volatile_publisher_is_asked_without_qos_and_that_is_remembered(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(latched, "FIRST_PATIENCE", 0.5)
    monkeypatch.setattr(wire, "AGAIN", 0.05)
    play(server, [("volatile-maps", "robot_0")])

    def known(state: FleetState) -> bool:
        robot_map = state.robots["robot_0"].maps["floor_0"]
        return bool(robot_map.graph and robot_map.labels and robot_map.frame)

    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(known, within=HANGS)
        assert asked_with_qos(server) == [True, False]
        await server.restart_bridge()
        await store.until(lambda state: not phase(Phase.UP)(state))
        await store.until(lambda _: asked_with_qos(server) == [True, False, False])


async def test_what_has_come_is_left_alone_when_a_map_is_shown(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        await store.until(lambda _: all(counts(link)[:3]))
        monkeypatch.setattr(latched, "FIRST_PATIENCE", 0.3)
        link.show_map("robot_0", "floor_0")
        await store.until(lambda _: counts(link)[3])
        link.show_map("robot_0", "")
        server.bridge.muted.add("/robot_0/floor_0/map")
        link.show_map("robot_0", "floor_0")
        await store.until(lambda _: asked_for(server, "unsubscribe", "floor_0/map") > 1)
        assert not asked_for(server, "unsubscribe", "graph") and asked_with_qos(server) == [True]


def asked_for(server: RosbridgeServer, op: str, topic: str) -> int:
    return sum(one["op"] == op and topic in one["topic"] for one in server.bridge.received if "topic" in one)


def asked_with_qos(server: RosbridgeServer) -> list[bool]:
    """Tell for each subscription of a graph, in sequence, whether it asked for a QoS."""
    return [
        "qos" in one for one in server.bridge.received if one["op"] == "subscribe" and "graph" in one["topic"]
    ]


async def test_telemetry_is_asked_for_without_qos_and_commands_work(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        asked = {one["topic"]: "qos" in one for one in server.bridge.received if one["op"] == "subscribe"}
    assert not asked["/robot_0/pose"] and not asked["/robot_0/queue"] and asked["/robot_0/floor_0/graph"]


async def test_a_map_larger_than_the_messages_of_the_bridge_comes_as_png(server: RosbridgeServer) -> None:
    server.bridge.max_message_size = 2_000
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        state = await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid and state)
        assert map_requests(server) == ["png"]
        assert not state.links["rosbridge"].faults


def map_requests(server: RosbridgeServer) -> list[str]:
    """The encodings in which the map was asked for."""
    return [
        one["compression"]
        for one in server.bridge.received
        if one.get("topic") == "/robot_0/floor_0/map" and one["op"] == "subscribe"
    ]


async def test_why_the_bridge_did_not_subscribe_a_topic_is_in_the_log(
    server: RosbridgeServer, caplog: pytest.LogCaptureFixture
) -> None:
    play(server, [("unsourced", "robot_0")])
    async with linked(config_of(server.url, 1)) as (link, store):
        topic = link.counters["rosbridge"].topics["/robot_0/queue"]
        await store.until(lambda _: topic.not_subscribed)
        assert topic.not_subscribed.startswith("bridge: Unable to import oh_ressources")
    assert "bridge did not subscribe /robot_0/queue: Unable to import" in caplog.text


async def test_a_pose_arrives_though_its_publisher_is_volatile(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Asked for again on each connection: the other kind of publisher tells its last value only so."""
    monkeypatch.setattr(latched, "FIRST_PATIENCE", 0.5)
    monkeypatch.setattr(wire, "AGAIN", 0.05)
    play(site.server, [("volatile-pose", R0)])
    async with linked(site.config) as (_, store):
        await store.until(lambda state: state.robots[R0].pose, within=HANGS)
        assert poses_asked(site.server) == [True, False]
        await site.server.restart_bridge()
        await store.until(lambda _: poses_asked(site.server) == [True, False, True, False], within=HANGS)


async def test_a_latched_pose_that_is_yet_to_come_is_asked_for_in_one_other_way(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(latched, "FIRST_PATIENCE", 0.1)
    site.server.bridge.muted.add(f"/{R0}/amcl_pose")
    async with linked(site.config) as (link, store):
        await store.until(lambda _: len(poses_asked(site.server)) == 2, within=HANGS)
        site.server.bridge.muted.clear()
        link.submit(site.to("Receiving"))
        await store.until(lambda state: state.robots[R0].pose, within=HANGS)
        assert poses_asked(site.server) == [True, False]


def poses_asked(server: RosbridgeServer) -> list[bool]:
    """Tell for each subscription of a pose, in sequence, whether it asked for a QoS."""
    return [
        "qos" in one
        for one in server.bridge.received
        if one["op"] == "subscribe" and one["topic"] == f"/{R0}/amcl_pose"
    ]


async def test_what_came_while_other_topics_were_asked_for_is_not_fetched_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(latched, "FIRST_PATIENCE", HANGS)
    monkeypatch.setattr(subscriber, "AT_ONCE", 10)
    server = RosbridgeServer(OhFleet(12, 1, seed=1, quiet=True), dialect=ROS2)
    await server.start()
    server.bridge.started -= LONG_AGO
    try:
        async with linked(config_of(server.url, 12)) as (link, store):
            await store.until(lambda _: all(counts(link, 12)[:36]))
            monkeypatch.setattr(latched, "FIRST_PATIENCE", 0.1)
            server.bridge.muted.add("/robot_0/floor_0/map")
            link.show_map("robot_0", "floor_0")
            await store.until(lambda _: asked_for(server, "unsubscribe", "floor_0/map"))
            # All are looked at in one go.
            assert asked_for(server, "unsubscribe", "floor_0") == 1
    finally:
        await server.stop()
