"""One client: its frames in order, whatever is in them."""

import asyncio
import json

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import frames_before_an_answer, read, subscribe

POSE, POSE_TYPE = "/robot_0/pose", "geometry_msgs/PoseStamped"
GRAPH, GRAPH_TYPE = "/robot_0/floor_0/graph", "OH_ressources/Graph"


NONSENSE: list[str | bytes] = [
    '{"op":',
    "[]",
    "7",
    b"\x00\x01",
    '{"op":"nonsense"}',
    '{"op":7}',
    "{}",
    '{"op":"subscribe"}',
    '{"op":"subscribe","topic":7}',
    '{"op":"call_service"}',
    '{"op":"advertise","topic":"/x","type":"std_msgs/Bool"}',
    '{"op":"publish","topic":"/x","msg":{}}',
    '{"op":"unsubscribe","topic":"/never"}',
    json.dumps({"op": "subscribe", "topic": GRAPH, "type": GRAPH_TYPE, "throttle_rate": "100"}),
    json.dumps({"op": "subscribe", "topic": GRAPH, "type": GRAPH_TYPE, "throttle_rate": 1.5}),
    json.dumps({"op": "subscribe", "topic": GRAPH, "type": "std_msgs/Bool"}),
    json.dumps({"op": "subscribe", "topic": "/no/such/topic"}),
]


async def test_nothing_is_said_about_nonsense_and_the_connection_lives(client: ClientConnection) -> None:
    for frame in NONSENSE:
        await client.send(frame)
    assert await frames_before_an_answer(client) == []


async def test_calls_wait_behind_subscribes(server: RosbridgeServer, client: ClientConnection) -> None:
    server.bridge.subscribe_delay = 0.1
    for floor in ("floor_0", "floor_1"):
        await subscribe(client, f"/robot_0/{floor}/graph", GRAPH_TYPE)
    clock = asyncio.get_running_loop().time
    begun = clock()
    assert len(await frames_before_an_answer(client)) == 2
    assert clock() - begun > 0.15


async def test_a_client_that_does_not_read_holds_up_nobody(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    async with connect(server.url, max_size=None) as slow:
        await subscribe(slow, POSE, POSE_TYPE)
        await read(slow)
        slow.transport.pause_reading()
        server.bridge.publish_raw(POSE, "x" * 20_000_000)
        await subscribe(client, POSE, POSE_TYPE)
        for _ in range(25):
            last = await read(client)
        slow.transport.resume_reading()
        while not str(await slow.recv()).startswith("x"):
            pass
        after = [(await read(slow))["msg"]["header"]["seq"] for _ in range(2)]
    assert after[-1] >= last["msg"]["header"]["seq"]
