"""Behaviour of a ROS 2 bridge towards clients that expect ROS 1."""

from collections.abc import AsyncIterator

import pytest

from fleet_tui.console.demo import demo_config
from fleet_tui.links.rosbridge import latched
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_faults import all_online, raised
from tests.support.fault_report import report
from tests.support.fleets import place_order
from tests.support.invariants import linked
from tests.support.links import finished, ready
from tests.support.polling import HANGS
from tests.support.proxied_link import Stopwatch, fresh, lost, usual
from tests.support.shown_text import shown


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    """Two quiet robots behind a bridge of ROS 2."""
    running = RosbridgeServer(OhFleet(robots=2, floors=1, seed=1, quiet=True), dialect=ROS2)
    await running.start()
    yield running
    await running.stop()


def stages(state: FleetState) -> set[Stage]:
    """The stages of the newest command."""
    return {step.stage for step in state.commands[-1].steps}


async def test_the_bridge_gives_a_call_up(server: RosbridgeServer) -> None:
    play(server, [("slow-answer", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        link.submit(place_order("robot_0", 19, 0))
        noticed = await watch.until(
            lambda state: state.commands and stages(state) & {Stage.UNKNOWN, Stage.NO_ANSWER}
        )
        healed = await watch.until(lambda state: state.commands[-1].stage is Stage.CONFIRMED)
        assert Stage.REFUSED not in stages(store.state)
        assert not raised("command")(store.state)
    seen = "no answer or outcome unknown; confirmed once the order is seen in the queue"
    report("ROS 2: the bridge abandons a call", "after 5 s; the robot answers after 6", seen, noticed, healed)


async def test_the_bridge_is_restarted_with_latched_topics(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(latched, "FIRST_PATIENCE", 4.0)
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        names = [f"/robot_{n}/floor_0/{name}" for n in (0, 1) for name in ("graph", "labeled_vertices")]
        topics = [link.counters["rosbridge"].topics[name] for name in names]
        before = [topic.count for topic in topics]
        watch = Stopwatch(store)
        await server.restart_bridge()
        noticed = await watch.until(lost())
        watch.start()
        healed = await watch.until(
            lambda state: (
                ready(state) and all(topic.count > then for topic, then in zip(topics, before, strict=True))
            )
        )
        asked = [
            one for one in server.bridge.received if one["op"] == "subscribe" and one["topic"] == names[0]
        ]
        assert len(asked) == 2, "it came only when it was asked for once more"
        record = await finished(link, store, place_order("robot_0", 19, 0))
        assert record.stage is Stage.CONFIRMED
    seen = "connection lost; then graphs and labels return"
    report("ROS 2: the bridge is restarted", "latched topics are subscribed at once", seen, noticed, healed)


async def test_maps_and_graphs_are_published_volatile(server: RosbridgeServer) -> None:
    play(server, [("volatile-maps", "robot_0"), ("volatile-maps", "robot_1")])
    async with linked(usual(server.url, 2)) as (link, store):
        watch = Stopwatch(store)
        healed = await watch.until(ready)
        assert (await finished(link, store, place_order("robot_0", 19, 0))).stage is Stage.CONFIRMED
    seen = "nothing: they are subscribed again without quality of service"
    report("ROS 2: graphs are published volatile", f"every {wire.AGAIN:g} s, not latched", seen, None, healed)


async def test_a_map_is_larger_than_the_bridges_messages(server: RosbridgeServer) -> None:
    server.bridge.max_message_size = 60_000
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        link.show_map("robot_0", "floor_0")
        healed = await watch.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
        assert not store.state.links["rosbridge"].faults
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
    seen = "nothing: maps come as png, in fragments if need be"
    report("ROS 2: a map over max_message_size", "it never arrives as cbor", seen, None, healed)


async def test_the_bridge_is_overloaded(server: RosbridgeServer) -> None:
    def in_time(state: FleetState) -> bool:
        return not raised("late")(state) and all_online(state)

    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(ready)
        server.bridge.services.capacity = 20.0
        watch = Stopwatch(store)
        noticed = await watch.until(raised("late"), within=HANGS)
        assert "late: bridge overloaded" in shown(store.state)
        assert not raised("behind")(store.state) and all_online(store.state)
        server.bridge.services.capacity = None
        watch.start()
        healed = await watch.until(in_time)
    seen = "messages N s late: bridge overloaded, one alarm; no robot is blamed"
    report("ROS 2: an overloaded bridge", "it forwards half of the messages", seen, noticed, healed)


async def test_a_robot_loses_power_behind_an_overloaded_bridge(server: RosbridgeServer) -> None:
    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(ready)
        server.bridge.services.lag = 2.0
        await store.until(raised("late"))
        assert not raised("offline")(store.state)
        play(server, [("silent", "robot_1")])
        watch = Stopwatch(store)
        noticed = await watch.until(raised("offline"))
        assert {one.condition.source for one in store.state.alarms if one.condition.kind == "offline"} == {
            "robot_1"
        }
    seen = "messages N s late: bridge overloaded; and that robot offline"
    report("ROS 2: a robot loses power behind an overloaded bridge", "it is 2 s late", seen, noticed, None)


async def test_rosapi_has_died(server: RosbridgeServer) -> None:
    """Nobody tells how this bridge spells the types then: the config must."""
    play(server, [("dead-rosapi", "robot_0")])
    config = demo_config(usual(server.url, 2), server.url, 2, 1, ros="2")
    async with linked(config) as (link, store):
        watch = Stopwatch(store)
        healed = await watch.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert not raised("commands")(store.state)
    seen = "nothing: commands and telemetry continue"
    report(
        "ROS 2: rosapi has died",
        "a request of another client crashed it; the configuration has ROS 2's types",
        seen,
        None,
        healed,
    )


async def test_an_allow_list_lacks_topics(server: RosbridgeServer) -> None:
    async with linked(usual(server.url, 2)) as (_, store):
        await store.until(ready)
        play(server, [("topics-glob", "robot_0")])
        await server.restart_bridge()
        watch = Stopwatch(store)
        noticed = await watch.until(raised("messages"))
        assert "the bridge does not allow /robot_0/" in shown(store.state)
        assert not raised("offline")(store.state)
        server.bridge.allowed.clear()
        await server.restart_bridge()
        watch.start()
        healed = await watch.until(lambda state: ready(state) and all_online(state))
    seen = "the bridge does not allow /robot_0/... (topics_glob); no robot is blamed"
    report("ROS 2: an allow-list lacks topics", "topics_glob, since a restart", seen, noticed, healed)


async def test_an_allow_list_lacks_services(server: RosbridgeServer) -> None:
    play(server, [("services-glob", "robot_0")])
    async with linked(usual(server.url, 2)) as (link, store):
        await store.until(ready)
        watch = Stopwatch(store)
        link.submit(place_order("robot_0", 19, 0))
        noticed = await watch.until(
            lambda state: state.commands and state.commands[-1].stage is Stage.NOT_SENT
        )
        await store.until(lambda state: "the bridge does not allow it (services_glob)" in shown(state))
        server.bridge.allowed.clear()
        before = store.state.links["rosbridge"].since
        await server.restart_bridge()
        watch.start()
        await store.until(lambda state: state.links["rosbridge"].since > before)
        healed = await watch.until(fresh())
        assert (await finished(link, store, place_order("robot_0", 19, 0))).stage is Stage.CONFIRMED
    seen = "not sent: the bridge does not allow it (services_glob)"
    report("ROS 2: an allow-list lacks services", "services_glob drops an order", seen, noticed, healed)
