"""The server over real connections. Nothing sleeps: every wait is for a frame."""

import asyncio
import base64
import io
import json
import math
from itertools import pairwise

import cbor2
import pytest
from PIL import Image
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from fleet_tui.errors import FleetError
from fleet_tui.simulator.ros_types import ServiceError
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import (
    Json,
    call,
    frames_before_an_answer,
    read,
    read_until,
    send,
)

POSE, POSE_TYPE = "/robot_0/pose", "geometry_msgs/PoseStamped"
GRAPH, GRAPH_TYPE = "/robot_0/floor_0/graph", "OH_ressources/Graph"
MAP, MAP_TYPE = "/robot_0/floor_0/map", "nav_msgs/OccupancyGrid"
ORDER = "/robot_0/Application_layout/Execute_order"
PAUSE = "/robot_0/Application_layout/Pause"
ARGS = {"request_id": 1, "initial_point": 2, "end_point": 5}


async def subscribe(client: ClientConnection, topic: str, type_: str | None, **fields: object) -> None:
    typed = {} if type_ is None else {"type": type_}
    await send(client, "subscribe", topic=topic, queue_length=1, **typed, **fields)


async def test_poses_flow_to_every_client_alike(server: RosbridgeServer, client: ClientConnection) -> None:
    async with connect(server.url) as other:
        for each in (client, other):
            await subscribe(each, POSE, POSE_TYPE)
        seen = [await client.recv() for _ in range(10)]
        others = [await other.recv() for _ in range(10)]
    assert str(seen[0]).startswith('{"op":"publish","topic":"\\/robot_0\\/pose","msg":{"header":{"seq":')
    assert len(set(seen) & set(others)) >= 5
    numbers = [json.loads(frame)["msg"]["header"]["seq"] for frame in seen]
    assert numbers == sorted(set(numbers))


async def test_an_order_shows_in_the_queue_and_moves_the_robot(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    await subscribe(client, POSE, POSE_TYPE)
    first = await read(client)
    await subscribe(client, "/robot_0/queue", "OH_ressources/ActionQueue")
    answer = await call(client, ORDER, ARGS)
    assert answer["values"] == {"request_id": 1, "status": "ACCEPTED"}
    frames = await read_until(client, lambda frame: frame.get("msg", {}).get("current_order_id") == 1)
    assert frames[-1]["msg"]["orders"] == [{"id": 1, "start": 2, "end": 5, "status": "W"}]
    await read_until(
        client, lambda frame: frame["topic"] == POSE and frame["msg"]["pose"] != first["msg"]["pose"]
    )
    assert server.bridge.services.calls == [(ORDER, ARGS)]


@pytest.mark.parametrize("args", [None, {}, [], "nonsense", 7])
async def test_missing_arguments_are_zeros_and_accepted(client: ClientConnection, args: object) -> None:
    answer = await call(client, ORDER, args)
    assert (answer["values"], answer["result"]) == ({"request_id": 0, "status": "ACCEPTED"}, True)


async def test_arguments_may_come_as_a_list_in_order(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    await call(client, ORDER, [4, 2, 5])
    (order,) = server.world.robots["robot_0"].orders
    assert (order.start, order.end, server.world.robots["robot_0"].request_id) == (2, 5, 4)


TYPE = "OH_ressources/Execute_manual_orderRequest"


@pytest.mark.parametrize(
    ("args", "refusal"),
    [
        (
            {"request_id": 7.0},
            f"{TYPE} message requires a int32 for field request_id, but got a <class 'float'>",
        ),
        (
            {"end_point": None},
            f"{TYPE} message requires a int32 for field end_point, but got a <class 'NoneType'>",
        ),
        (
            {"end_point": True},
            f"{TYPE} message requires a int32 for field end_point, but got a <class 'bool'>",
        ),
        ({"end": 1}, f"Message type {TYPE} does not have a field end"),
        ({"end_point": 2**31}, "field end_point exceeds specified width [int32]"),
    ],
)
async def test_wrong_arguments_are_refused(
    server: RosbridgeServer, client: ClientConnection, args: Json, refusal: str
) -> None:
    answer = await call(client, ORDER, args)
    assert (answer["values"], answer["result"]) == (refusal, False)
    assert server.world.robots["robot_0"].orders == []


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


async def test_calls_wait_behind_subscribes(server: RosbridgeServer, client: ClientConnection) -> None:
    server.bridge.subscribe_delay = 0.1
    for floor in ("floor_0", "floor_1"):
        await subscribe(client, f"/robot_0/{floor}/graph", GRAPH_TYPE)
    clock = asyncio.get_running_loop().time
    begun = clock()
    assert len(await frames_before_an_answer(client)) == 2
    assert clock() - begun > 0.15


async def test_a_map_is_the_same_in_all_three_compressions(client: ClientConnection) -> None:
    await subscribe(client, MAP, MAP_TYPE)
    plain = (await read(client))["msg"]
    await send(client, "unsubscribe", topic=MAP)
    await subscribe(client, MAP, MAP_TYPE, compression="png")
    wrapped = await read(client)
    await send(client, "unsubscribe", topic=MAP)
    await subscribe(client, MAP, MAP_TYPE, compression="cbor")
    binary = cbor2.loads(bytes(await client.recv(decode=False)))
    assert wrapped["op"] == "png"
    picture = Image.open(io.BytesIO(base64.b64decode(wrapped["data"])))
    assert json.loads(picture.tobytes())["msg"] == plain
    tag = binary["msg"].pop("data")
    assert [value - 256 if value > 127 else value for value in tag.value] == plain.pop("data")
    assert binary["msg"] == plain


async def test_no_number_is_null_in_json_and_itself_in_cbor(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    topic, msg = "/robot_0/battery", {"data": math.nan, "ranges": [math.inf, -math.inf, 1.5]}
    await subscribe(client, topic, None)
    async with connect(server.url) as other:
        await subscribe(other, topic, None, compression="cbor")
        await frames_before_an_answer(client)
        while server.bridge.subscribers(topic) < 2:
            await read(client)
        server.bridge.publish_raw(topic, msg)
        injected = await read_until(client, lambda frame: "ranges" in frame["msg"])
        real = cbor2.loads(bytes(await other.recv(decode=False)))
        while "ranges" not in real["msg"]:
            real = cbor2.loads(bytes(await other.recv(decode=False)))
    assert injected[-1]["msg"] == {"data": None, "ranges": [None, None, 1.5]}
    assert math.isnan(real["msg"]["data"])
    assert real["msg"]["ranges"] == [math.inf, -math.inf, 1.5]


async def test_strings_pass_unharmed(server: RosbridgeServer, client: ClientConnection) -> None:
    await subscribe(client, "/later", "std_msgs/String")
    await frames_before_an_answer(client)
    text = "\x1b[31m \n ñ 🤖 \ufffd / \\"
    server.bridge.publish_raw("/later", {"data": text})
    assert (await read(client))["msg"]["data"] == text
    server.bridge.publish_raw("/later", "no { json")
    assert await client.recv() == "no { json"


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


async def test_the_bridge_counts_its_clients(server: RosbridgeServer, client: ClientConnection) -> None:
    await subscribe(client, "/client_count", "std_msgs/Int32")
    assert (await read(client))["msg"] == {"data": 1}
    async with connect(server.url):
        assert (await read(client))["msg"] == {"data": 2}
    assert (await read(client))["msg"] == {"data": 1}


async def test_a_silent_robot_says_nothing_but_its_maps(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    server.world.robots["robot_0"].silence = 1000.0
    for name in ("robot_0", "robot_1"):
        await subscribe(client, f"/{name}/pose", POSE_TYPE)
    await subscribe(client, GRAPH, GRAPH_TYPE)
    seen = [(await read(client))["topic"] for _ in range(30)]
    assert set(seen) == {"/robot_1/pose", GRAPH}


async def test_rosapi_answers_emptily_about_unknown_names(client: ClientConnection) -> None:
    for verb, args, empty in (
        ("topic_type", {"topic": "/x"}, {"type": ""}),
        ("service_type", {"service": "/x"}, {"type": ""}),
        ("service_node", {"service": "/x"}, {"node": ""}),
        ("publishers", {"topic": "/x"}, {"publishers": []}),
        ("subscribers", {"topic": "/x"}, {"subscribers": []}),
        ("topics_for_type", {"type": "x/X"}, {"topics": []}),
        ("message_details", {"type": "x/X"}, {"typedefs": []}),
    ):
        answer = await call(client, f"/rosapi/{verb}", args)
        assert (answer["values"], answer["result"]) == (empty, True)


async def test_rosapi_knows_who_subscribes(client: ClientConnection) -> None:
    await subscribe(client, GRAPH, GRAPH_TYPE)
    answer = await call(client, "/rosapi/subscribers", {"topic": GRAPH})
    assert answer["values"] == {"subscribers": ["/rosbridge_websocket"]}
    answer = await call(client, "/rosapi/topics_for_type", {"type": POSE_TYPE})
    assert answer["values"] == {"topics": ["/robot_0/pose", "/robot_1/pose"]}


class TestDoors:
    async def test_a_silent_service_is_called_and_never_answers(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.silent_services.add(PAUSE)
        await send(client, "call_service", service=PAUSE, id="p")
        assert await frames_before_an_answer(client) == []
        assert server.bridge.services.calls == [(PAUSE, {})]
        assert not server.world.robots["robot_0"].paused

    async def test_answers_are_overridden(self, server: RosbridgeServer, client: ClientConnection) -> None:
        def broken(args: Json) -> Json:
            raise ServiceError(f"service [{PAUSE}] responded with an error: {args}")

        server.bridge.services.answers[ORDER] = lambda args: {
            "request_id": args["request_id"],
            "status": "REJECTED: too tired",
        }
        server.bridge.services.answers[PAUSE] = broken
        answer = await call(client, ORDER, {"request_id": 3})
        assert answer["values"] == {"request_id": 3, "status": "REJECTED: too tired"}
        answer = await call(client, PAUSE)
        assert (answer["values"], answer["result"]) == (
            f"service [{PAUSE}] responded with an error: {{}}",
            False,
        )

    async def test_without_a_master_calls_fail_and_topics_go_on(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.master_alive = False
        for service in (PAUSE, "/rosapi/topics"):
            answer = await call(client, service)
            assert (answer["values"], answer["result"]) == ("Unable to communicate with master!", False)
        await subscribe(client, POSE, POSE_TYPE)
        assert (await read(client))["topic"] == POSE

    async def test_without_rosapi_its_services_do_not_exist(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.rosapi_alive = False
        answer = await call(client, "/rosapi/topics")
        assert (answer["values"], answer["result"]) == ("Service /rosapi/topics does not exist", False)
        assert (await call(client, PAUSE))["result"]

    async def test_a_muted_topic_is_not_published(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.muted |= {POSE, GRAPH}
        await subscribe(client, POSE, POSE_TYPE)
        await subscribe(client, GRAPH, GRAPH_TYPE)
        await subscribe(client, "/robot_1/pose", POSE_TYPE)
        assert {(await read(client))["topic"] for _ in range(20)} == {"/robot_1/pose"}
        server.bridge.muted.clear()
        await read_until(client, lambda frame: frame["topic"] == POSE)

    async def test_dropped_clients_may_come_back(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        await subscribe(client, POSE, POSE_TYPE)
        await read(client)
        await server.drop_clients()
        with pytest.raises(ConnectionClosed):
            while True:
                await client.recv()
        assert server.bridge.subscribers(POSE) == 0
        async with connect(server.url) as again:
            await subscribe(again, POSE, POSE_TYPE)
            assert (await read(again))["topic"] == POSE

    async def test_every_operation_is_kept(self, server: RosbridgeServer, client: ClientConnection) -> None:
        await send(client, "nonsense", x=1)
        await frames_before_an_answer(client)
        assert list(server.bridge.received) == [
            {"op": "nonsense", "x": 1},
            {"op": "call_service", "service": "/rosapi/get_time", "id": "last"},
        ]
        assert server.bridge.services.calls == []


async def test_a_taken_port_is_named_with_a_remedy(server: RosbridgeServer) -> None:
    port = int(server.url.rsplit(":", 1)[1])
    with pytest.raises(FleetError, match=rf"port {port} .* is in use: .* --port"):
        await RosbridgeServer(server.world, port=port).start()
