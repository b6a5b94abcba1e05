"""Topics: latched, throttled, shared and left."""

from itertools import pairwise

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import frames_before_an_answer, read, send, subscribe

POSE, POSE_TYPE = "/robot_0/pose", "geometry_msgs/PoseStamped"
GRAPH, GRAPH_TYPE = "/robot_0/floor_0/graph", "OH_ressources/Graph"


async def test_a_latched_topic_is_said_at_every_subscribe_and_to_every_client(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    for id_ in ("a", "a", "b"):
        await subscribe(client, GRAPH, None, id=id_)
        assert len((await read(client))["msg"]["vertices"]) == 20
    assert await frames_before_an_answer(client) == []
    async with connect(server.url) as other:
        await subscribe(other, GRAPH, GRAPH_TYPE)
        assert (await read(other))["topic"] == GRAPH


async def test_throttled_without_a_queue_the_latched_value_is_lost(client: ClientConnection) -> None:
    for id_ in ("a", "b"):
        await send(client, "subscribe", topic=GRAPH, id=id_, throttle_rate=60_000, queue_length=0)
    assert len(await frames_before_an_answer(client)) == 1


async def test_a_throttled_topic_comes_at_its_own_pace(client: ClientConnection) -> None:
    await subscribe(client, POSE, POSE_TYPE, throttle_rate=200)
    numbers = [(await read(client))["msg"]["header"]["seq"] for _ in range(5)]
    steps = [later - earlier for earlier, later in pairwise(numbers)]
    assert min(steps) >= 4, steps  # 10 on an idle machine


async def test_unsubscribing_ends_it_but_for_what_others_asked(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    for id_ in ("a", "b"):
        await subscribe(client, POSE, POSE_TYPE, id=id_)
    await send(client, "unsubscribe", topic=POSE, id="a")
    await frames_before_an_answer(client)
    assert (await read(client))["topic"] == POSE
    await send(client, "unsubscribe", topic=POSE)
    await frames_before_an_answer(client)
    assert server.bridge.subscribers(POSE) == 0


async def test_a_topic_that_is_to_come_flows_when_it_is_there(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    await subscribe(client, "/later", "std_msgs/Bool")
    assert await frames_before_an_answer(client) == []
    assert server.bridge.publish_raw("/later", {"data": True}) == 1
    assert await read(client) == {"op": "publish", "topic": "/later", "msg": {"data": True}}


async def test_a_silent_robot_says_nothing_but_its_maps(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    server.world.robots["robot_0"].silence = 1000.0
    for name in ("robot_0", "robot_1"):
        await subscribe(client, f"/{name}/pose", POSE_TYPE)
    await subscribe(client, GRAPH, GRAPH_TYPE)
    seen = [(await read(client))["topic"] for _ in range(30)]
    assert set(seen) == {"/robot_1/pose", GRAPH}
