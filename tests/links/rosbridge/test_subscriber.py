"""Subscriptions: the most urgent first, of the right type, and each again after a drop."""

import json

import msgspec
from websockets.asyncio.client import connect

from fleet_tui.cli.status.report import attention
from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.model.link import Phase
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.situation.facts import LOST_SUBSCRIPTIONS, NOT_ALLOWED
from fleet_tui.situation.why.why import reasons
from tests.support.links import linked, phase, ready
from tests.support.watched_store import config_of


async def test_poses_are_subscribed_first_and_always_with_a_queue(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
        asked = [operation for operation in server.bridge.received if operation["op"] == "subscribe"]
    assert [operation["topic"] for operation in asked[:2]] == ["/robot_0/pose", "/robot_1/pose"]
    assert all(operation["queue_length"] >= 1 for operation in asked)
    assert all(type(operation["throttle_rate"]) is int for operation in asked)
    maps = [operation["topic"] for operation in asked if operation["topic"].endswith("/map")]
    assert maps == ["/robot_0/floor_0/map"]


async def test_a_bridge_of_ros_2_keeps_no_message_of_which_a_next_one_follows(ros_2: RosbridgeServer) -> None:
    """Each queue is a thread of it."""
    async with linked(demo_config(Config(), ros_2.url, 1, 1, "2")) as (_, store):
        await store.until(ready)
        asked = [operation for operation in ros_2.bridge.received if operation["op"] == "subscribe"]
    kept = {one["topic"].rpartition("/")[2]: one["queue_length"] for one in asked}
    assert {kept[name] for name in ("pose", "queue", "battery", "cargo")} == {0}
    assert kept["graph"] == kept["labeled_vertices"] == 1 and kept["rosout"] > 1


async def test_without_types_the_bridge_may_be_one_that_a_slow_client_stops(server: RosbridgeServer) -> None:
    server.bridge.services.rosapi_alive = False
    async with linked(config_of(server.url)) as (_, store):
        await store.until(ready)
        asked = [operation for operation in server.bridge.received if operation["op"] == "subscribe"]
    assert all(operation["queue_length"] >= 1 for operation in asked)


async def test_a_drop_is_shown_and_heals_with_every_subscription(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
        topics = {
            operation["topic"] for operation in server.bridge.received if operation["op"] == "subscribe"
        }
        await server.drop_clients()
        await store.until(phase(Phase.WAITING))
        server.bridge.received.clear()
        received = store.state.robots["robot_0"].last_received or 0.0
        await store.until(
            lambda state: phase(Phase.UP)(state) and (state.robots["robot_0"].last_received or 0) > received
        )
        await store.until(lambda _: server.bridge.subscribers("/robot_0/floor_0/map") == 1)
        again = {operation["topic"] for operation in server.bridge.received if operation["op"] == "subscribe"}
    assert again == topics


async def test_a_topic_of_another_type_is_not_subscribed_and_said(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    profile = msgspec.structs.replace(config.profile, types={"battery": "std_msgs/Int8"})
    async with linked(msgspec.structs.replace(config, profile=profile)) as (_, store):
        state = await store.until(lambda state: state.robots["robot_0"].faults)
        await store.until(lambda state: state.robots["robot_0"].cargo)
        asked = [operation["topic"] for operation in server.bridge.received if operation["op"] == "subscribe"]
    assert (
        "/robot_0/battery has type std_msgs/Float32, not std_msgs/Int8" in state.robots["robot_0"].last_fault
    )
    assert "/robot_0/battery" not in asked


async def test_a_topic_that_died_alone_is_subscribed_again_without_the_others(
    server: RosbridgeServer,
) -> None:
    """As after a restart of roscore, when another client held it: the other topics of its robot are back."""
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(ready)
        server.bridge.received.clear()
        server.bridge.orphaned.add("/robot_0/battery")
        await store.until(lambda _: not server.bridge.orphaned)
        battery = store.state.robots["robot_0"].battery
        assert battery is not None
        await store.until(lambda state: state.robots["robot_0"].battery is not battery)
        asked = {one["topic"] for one in server.bridge.received if one["op"] == "subscribe"}
    assert asked == {"/robot_0/battery"}


async def test_a_bridge_that_lost_its_subscriptions_is_to_blame_and_no_robot(server: RosbridgeServer) -> None:
    """After a restart of roscore, while another client holds every topic."""
    async with linked(config_of(server.url, 2)) as (_, store), connect(server.url) as other:
        await store.until(ready)
        held = [name for name in server.bridge.subscribed() if name.startswith("/robot_0/")]
        for topic in held:
            await other.send(json.dumps({"op": "subscribe", "topic": topic}))
        await other.send('{"op":"call_service","id":"c","service":"/rosapi/get_time"}')
        while json.loads(await other.recv()).get("id") != "c":
            pass
        server.bridge.orphaned.update(held)
        state = await store.until(
            lambda state: any(one.condition.kind == "messages" and one.holds for one in state.alarms)
        )
        alarm = next(one for one in state.alarms if one.condition.kind == "messages")
        assert alarm.text == "rosbridge lost its subscriptions of robot_0: restart it"
        silent = [one.condition.remedy for one in state.alarms if one.condition.kind == "offline"]
        assert set(silent) <= {LOST_SUBSCRIPTIONS.action}
        why = reasons(state, state.robots["robot_0"])[0]
        assert (why.name, why.remedy) == (LOST_SUBSCRIPTIONS.word, LOST_SUBSCRIPTIONS.action)
        assert any("lost its subscriptions" in line for line in attention(state))
        server.bridge.orphaned.clear()
        await store.until(lambda state: not state.links["rosbridge"].dropped)


async def test_a_topic_that_an_allow_list_lacks_blames_the_list_and_no_robot(ros_2: RosbridgeServer) -> None:
    play(ros_2, [("topics-glob", "robot_0")])
    async with linked(config_of(ros_2.url, 2)) as (_, store):
        state = await store.until(
            lambda state: any(one.condition.kind == "messages" and one.holds for one in state.alarms)
        )
        alarm = next(one.condition for one in state.alarms if one.condition.kind == "messages")
        assert alarm.text.startswith("the bridge does not allow /robot_0/") and "topics_glob" in alarm.remedy
        later = state.now + 20.0
        state = await store.until(lambda state: state.now > later)
        assert not any(one.condition.source == "robot_0" for one in state.alarms)
        why = reasons(state, state.robots["robot_0"])[0]
        assert (why.name, why.remedy) == (NOT_ALLOWED.word, NOT_ALLOWED.action)
        assert any("does not allow" in line for line in attention(state))
