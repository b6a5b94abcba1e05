"""Counters of a link with a real server: rates, losses, bad data, the robots' log."""

from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.counting import counter, until
from tests.support.links import linked, path, phase, ready
from tests.support.watched_store import config_of

POSE = "/robot_0/pose"


async def test_topics_are_counted_with_their_rates_and_last_messages(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (link, store):
        await store.until(ready)
        it = counter(link).topics[POSE]
        await until(store, lambda: it.count > 25)
        rates, last = it.rates(store.state.now), it.last
        assert rates is not None and 5.0 < rates[0] < 20.0
        assert last is not None and b"frame_id" in last.payload
        assert counter(link).all.count >= sum(one.count for one in counter(link).topics.values())
        assert counter(link).topics["/robot_1/floor_1/graph"].count >= 1
        assert set(counter(link).topics) >= {POSE, "/rosout", "/diagnostics"}


async def test_bad_messages_are_kept_as_they_came(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url)) as (link, store):
        await store.until(ready)
        server.bridge.muted.add("/robot_0/battery")
        server.bridge.publish_raw("/robot_0/battery", {"percent": 40})
        it = counter(link).topics["/robot_0/battery"]
        await until(store, lambda: it.errors)
        assert it.bad is not None and "data" in it.bad.text and b'"percent":40' in it.bad.raw.payload
        server.bridge.publish_raw("/robot_0/battery", '{"op":"publish","topic"')
        await until(store, lambda: counter(link).unreadable)
        bad = counter(link).bad
        assert bad is not None and bad.raw.payload == b'{"op":"publish","topic"'


async def test_a_queue_with_a_part_that_is_left_out_is_an_error(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url)) as (link, store):
        await store.until(ready)
        server.bridge.publish_raw("/robot_0/floor_0/graph", {"vertices": [{"id": "x"}], "edges": []})
        it = counter(link).topics["/robot_0/floor_0/graph"]
        await until(store, lambda: it.errors)
        assert it.bad is not None and "vertices[0]" in it.bad.text


async def test_losses_and_round_trips(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url)) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        it = counter(link)
        await store.until(phase(Phase.UP))
        assert (it.connections, it.lost_at) == (1, None)
        await until(store, lambda: it.round_trips.took)
        assert 0.0 < it.round_trips.took[0] < 20.0
        await server.drop_clients()
        await until(store, lambda: it.connections == 2)
        assert it.lost_at is not None and it.lost_why


async def test_a_message_over_the_limit_is_dropped_and_counted(server: RosbridgeServer) -> None:
    import msgspec

    config = config_of(server.url)
    bridge = msgspec.structs.replace(config.rosbridge, max_message_mb=0.5)
    async with linked(msgspec.structs.replace(config, rosbridge=bridge)) as (link, store):
        await store.until(ready)
        server.bridge.publish_raw(POSE, {"pad": "x" * 600_000})
        await until(store, lambda: counter(link).dropped)
        bad = counter(link).topics[POSE].bad
        assert bad is not None and "0.6 MB" in bad.text
        assert bad.raw.size > 600_000 and bad.raw.payload.startswith(b'{"op":"publish"')


async def test_a_topic_of_a_wrong_type_says_why_it_is_not_subscribed(server: RosbridgeServer) -> None:
    import msgspec

    config = config_of(server.url)
    profile = Profile(types={"battery": "std_msgs/Float64"})
    async with linked(msgspec.structs.replace(config, profile=profile)) as (link, store):
        await until(store, lambda: counter(link).topics["/robot_0/battery"].not_subscribed)
        assert "std_msgs/Float32" in counter(link).topics["/robot_0/battery"].not_subscribed
