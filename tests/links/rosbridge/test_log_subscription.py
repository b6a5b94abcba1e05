"""The log and the health of robots, heard only while somebody listens."""

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.robots.ros import reading
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.counting import counter, until
from tests.support.links import linked, ready
from tests.support.watched_store import config_of


def asked(server: RosbridgeServer, op: str) -> list[str]:
    return [one["topic"] for one in server.bridge.received if one["op"] == op and one["topic"] in OVERHEARD]


OVERHEARD = (reading.ROSOUT, reading.DIAGNOSTICS)


async def test_log_and_health_are_asked_for_only_while_somebody_listens(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url)) as (link, store):
        await store.until(ready)
        assert asked(server, "subscribe") == []
        link.subscribe_logs(True)
        link.subscribe_logs(True)
        await until(store, lambda: asked(server, "subscribe") == list(OVERHEARD))
        server.bridge.publish_raw("/rosout", {"level": 8, "name": "/base", "msg": "motor hot"})
        server.bridge.publish_raw("/rosout", {"level": 8, "name": "/base"})
        await until(store, lambda: counter(link).topics["/rosout"].errors)
        assert [line.text for line in counter(link).log if line.node == "/base"] == ["motor hot"]
        await server.drop_clients()
        await until(store, lambda: len(asked(server, "subscribe")) == 4)
        link.subscribe_logs(False)
        await until(store, lambda: asked(server, "unsubscribe") == list(OVERHEARD))


async def test_no_map_is_in_the_log_of_a_bridge_with_small_messages(ros_2: RosbridgeServer) -> None:
    """It writes there all of what is too large for it as cbor."""
    ros_2.bridge.max_message_size = 60_000
    async with linked(demo_config(Config(), ros_2.url, 1, 1, "2")) as (link, store):
        link.subscribe_logs(True)
        await store.until(ready)
        await until(store, lambda: reading.ROSOUT in ros_2.bridge.subscribed())
        link.show_map("robot_0", "floor_0")
        state = await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid and state)
        frames = [one for one in counter(link).log if "max_message_size" in one.text]
        assert frames == [] and not state.links["rosbridge"].faults
        assert reading.ROSOUT in ros_2.bridge.subscribed()
