"""The simulator's ROS 2 dialect against recordings of a real bridge on ROS 2, and its traps."""

import asyncio
import base64
import json
from typing import Any

import cbor2
import numpy as np
import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import call, frames_before_an_answer, read, read_until, send
from tests.support.nav2_site import LONG_AGO
from tests.support.ros2_transcripts import given_up, recorded_answers, theirs
from tests.support.transcripts import frames, parsed, recording, shape, until_answer

Json = dict[str, Any]

PAUSE = "/robot_0/Application_layout/Pause"
GRAPH = "/robot_0/floor_0/graph"
LATCHED = {"durability": "transient_local", "reliability": "reliable", "history": "keep_last", "depth": 1}


@pytest.fixture
def server(ros2_server: RosbridgeServer) -> RosbridgeServer:
    return ros2_server


async def test_commands_are_answered_as_recorded(server: RosbridgeServer) -> None:
    wanted = recorded_answers("ros2-services.jsonl.gz")
    seen = 0
    async with connect(server.url) as client:
        for text in frames(recording("ros2-services.jsonl.gz"), "out"):
            operation = parsed(text)
            if operation["service"].startswith(("/probe", "/tb1", "/map_")):
                continue
            await client.send(text)
            answer, recorded = await until_answer(client, operation["id"]), wanted[operation["id"]]
            if recorded["result"]:  # the robot's own words differ
                assert shape(answer) == shape(recorded)
                words = recorded["values"].pop("status", None) or recorded["values"].pop("message", None)
                assert words is not None
                assert recorded["values"].items() <= answer["values"].items()
            else:
                assert answer == recorded
            seen += 1
    assert seen == 20


async def test_rosapi_answers_as_recorded(server: RosbridgeServer) -> None:
    wanted = recorded_answers("ros2-rosapi.jsonl.gz")
    same = ("topic_type", "service_type", "get_ros_version", "publishers", "topics_for_type")
    async with connect(server.url) as client:
        for text in map(theirs, frames(recording("ros2-rosapi.jsonl.gz"), "out")):
            text = text.replace("/fake_nav2", "/fleet")
            operation = parsed(text)
            verb = operation["service"].removeprefix("/rosapi/")
            if "/nope" in text and verb == "node_details":
                break  # here the recorded rosapi died
            await client.send(text)
            answer, recorded = await until_answer(client, operation["id"]), wanted[operation["id"]]
            assert list(answer["values"]) == list(recorded["values"])
            about_ours = "robot_1" in text or "nope" in text or verb in ("get_ros_version", "get_time")
            if about_ours and verb in same:
                assert answer == json.loads(theirs(json.dumps(recorded)))
            if verb == "topics":
                types = dict(zip(*answer["values"].values(), strict=True))
                told = dict(zip(*recorded["values"].values(), strict=True))
                assert {
                    theirs(name): type_ for name, type_ in told.items() if "/robot_1" in name
                }.items() <= (types.items())
            if verb == "services":
                known = set(answer["values"]["services"])
                assert {name for name in recorded["values"]["services"] if "/robot_1" in name} <= known


async def test_types_are_described_as_recorded(server: RosbridgeServer, client: ClientConnection) -> None:
    wanted = recorded_answers("ros2-rosapi-types.jsonl.gz")
    for text in frames(recording("ros2-rosapi-types.jsonl.gz"), "out"):
        operation = parsed(text)
        verb = operation["service"].removeprefix("/rosapi/")
        if "details" not in verb or "action" in verb or "BatteryState" in text or verb == "node_details":
            continue
        await client.send(text)
        answer, recorded = await until_answer(client, operation["id"]), wanted[operation["id"]]
        for typedef in (*answer["values"]["typedefs"], *recorded["values"]["typedefs"]):
            del typedef["constnames"], typedef["constvalues"]  # python's own attributes, with addresses
        assert answer == recorded


@pytest.mark.parametrize(
    ("service", "args"),
    [
        ("node_details", {"node": "/nope"}),
        ("has_param", {"name": "/run_id"}),
        ("action_type", {"action": "/x"}),
    ],
)
async def test_rosapi_dies_of_a_bad_question(client: ClientConnection, service: str, args: Json) -> None:
    limited = {"args": args, "timeout": 0.1}
    await send(client, "call_service", id="bad", service=f"/rosapi/{service}", **limited)
    answer = await until_answer(client, "bad")
    assert (answer["values"], answer["result"]) == (given_up(), False)
    answer = await call(client, "/rosapi/topics")
    assert answer["values"] == "Service /rosapi/topics does not exist"
    assert (await call(client, PAUSE))["result"]


@pytest.mark.parametrize(
    ("topic", "as_recorded"),
    [
        ("/robot_0/queue", "/robot_1/queue"),
        (GRAPH, "/robot_1/ground/graph"),
        ("/client_count", "/client_count"),
        ("/connected_clients", "/connected_clients"),
        ("/rosout", "/rosout"),
        ("/diagnostics", "/diagnostics"),
    ],
)
async def test_topics_have_the_recorded_shape(client: ClientConnection, topic: str, as_recorded: str) -> None:
    lines = map(parsed, frames(recording("ros2-topics.jsonl.gz"), "in"))
    recorded = next(frame for frame in lines if frame.get("topic") == as_recorded)
    await send(client, "subscribe", topic="/nope/x")  # a complaint for /rosout
    await send(client, "subscribe", topic=topic)
    assert shape((await read(client))["msg"]) == shape(recorded["msg"])


async def test_a_pose_has_a_stamp_and_no_seq(client: ClientConnection) -> None:
    await send(client, "subscribe", topic="robot_0/pose", type="geometry_msgs/PoseStamped")
    frame = await read(client)
    assert frame["topic"] == "robot_0/pose"
    assert list(frame["msg"]["header"]) == ["stamp", "frame_id"]
    assert list(frame["msg"]["header"]["stamp"]) == ["sec", "nanosec"]


async def test_a_map_comes_as_recorded_in_cbor_and_json(client: ClientConnection) -> None:
    for name, compression in (("ros2-map-cbor.jsonl.gz", "cbor"), ("ros2-map-json.jsonl.gz", "none")):
        for line in recording(name):
            if line["dir"] == "out":
                continue
            raw = base64.b64decode(line["binary"]) if "binary" in line else line["text"]
            decode = cbor2.loads if isinstance(raw, bytes) else json.loads
            await send(client, "subscribe", topic="/robot_0/floor_0/map", compression=compression)
            frame = await client.recv()
            assert type(frame) is type(raw)
            assert shape(decode(frame)["msg"]) == shape(decode(raw)["msg"])  # type: ignore[arg-type]  # as asserted
            await send(client, "unsubscribe", topic="/robot_0/floor_0/map")
            break


async def test_no_number_is_null_in_a_field_and_bare_in_a_fixed_array(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    (text,) = [text for text in frames(recording("ros2-qos.jsonl.gz"), "in") if "NaN" in text]
    await send(client, "subscribe", topic="/q/nan", type="geometry_msgs/msg/PoseWithCovarianceStamped")
    server_side = json.loads(text)["msg"]
    server_side["pose"]["covariance"] = np.array(server_side["pose"]["covariance"])
    server_side["pose"]["pose"]["position"]["x"] = float("nan")
    await frames_before_an_answer(client)
    server.bridge.publish_raw("/q/nan", server_side)
    assert await client.recv() == text


class TestQualityOfService:
    async def test_latched_values_come_to_every_client_of_an_old_bridge(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        async with connect(server.url) as other:
            for each in (client, other, client):
                await send(each, "subscribe", topic=GRAPH)
                assert (await read(each))["topic"] == GRAPH

    async def test_who_asks_too_early_takes_the_latched_value_from_everybody(
        self, server: RosbridgeServer
    ) -> None:
        await server.restart_bridge()
        async with connect(server.url) as early, connect(server.url) as late:
            await send(early, "subscribe", topic=GRAPH, type="oh_ressources/msg/Graph")
            assert await frames_before_an_answer(early) == []
            server.bridge.started -= LONG_AGO
            await send(late, "subscribe", topic=GRAPH, type="oh_ressources/msg/Graph")
            assert await frames_before_an_answer(late) == []
            for waited, comes in ((0.0, False), (0.5, True)):  # as recorded
                for each in (early, late):
                    await send(each, "unsubscribe", topic=GRAPH)
                    await frames_before_an_answer(each)
                server.bridge.started -= waited
                await send(late, "subscribe", topic=GRAPH, type="oh_ressources/msg/Graph")
                assert bool(await frames_before_an_answer(late)) is comes

    async def test_asked_for_latched_values_come_when_the_publisher_is_discovered(
        self, server: RosbridgeServer
    ) -> None:
        await server.restart_bridge()
        begun = asyncio.get_running_loop().time()
        lines = recording("ros2-restart-with-qos.jsonl.gz")
        (asked,), (recorded,) = frames(lines, "out"), frames(lines, "in")
        async with connect(server.url) as client:
            await client.send(theirs(asked))
            frame = await read(client)
            assert shape(frame) == shape(json.loads(theirs(recorded)))
            assert frame["topic"] == "/robot_1/floor_0/graph"
            assert asyncio.get_running_loop().time() - begun > 0.2

    async def test_a_volatile_publisher_never_serves_one_who_asks_for_latched_values(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        play(server, parse_faults("volatile-maps:robot_0", server.world.robots))
        async with connect(server.url) as other:
            await send(client, "subscribe", topic=GRAPH, qos=LATCHED)
            await send(other, "subscribe", topic=GRAPH)
            await send(other, "subscribe", topic="/robot_0/pose")
            assert {(await read(other))["topic"] for _ in range(10)} == {"/robot_0/pose"}
            await send(client, "unsubscribe", topic=GRAPH)
            await send(other, "unsubscribe", topic=GRAPH)
            await frames_before_an_answer(client)
            await frames_before_an_answer(other)
            server.bridge.started -= 0.5
            await send(client, "subscribe", topic=GRAPH)
            assert (await read(client))["topic"] == GRAPH

    async def test_a_wrong_type_before_the_publisher_poisons_the_topic(self, server: RosbridgeServer) -> None:
        await server.restart_bridge()
        async with connect(server.url) as wrong, connect(server.url) as right:
            await send(wrong, "subscribe", topic="/robot_0/pose", type="std_msgs/msg/Float32")
            await frames_before_an_answer(wrong)
            server.bridge.started -= LONG_AGO
            await send(right, "subscribe", topic="/robot_0/pose", type="geometry_msgs/PoseStamped")
            await send(right, "subscribe", topic="/robot_1/pose")
            assert {(await read(right))["topic"] for _ in range(10)} == {"/robot_1/pose"}
            await send(wrong, "unsubscribe", topic="/robot_0/pose")
            await send(right, "unsubscribe", topic="/robot_0/pose")
            await frames_before_an_answer(wrong)
            server.bridge.started -= 0.5
            await send(right, "subscribe", topic="/robot_0/pose", type="geometry_msgs/PoseStamped")
            await read_until(right, lambda frame: frame.get("topic") == "/robot_0/pose")

    async def test_a_wrong_type_on_a_live_topic_is_harmless(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        await send(client, "subscribe", topic="/robot_0/pose", type="std_msgs/msg/String")
        await send(client, "subscribe", topic="/robot_0/queue", type="OH_ressources/ActionQueue")
        assert await frames_before_an_answer(client) == []
        await send(client, "subscribe", topic="/robot_0/pose")
        assert (await read(client))["topic"] == "/robot_0/pose"

    async def test_a_restarted_bridge_knows_nobody_and_the_robots_live_on(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        url = server.url
        server.world.robots["robot_0"].take(0, 2, request_id=1)
        await send(client, "subscribe", topic="/robot_0/pose")
        await read(client)
        await server.restart_bridge()
        with pytest.raises(ConnectionClosed):
            while True:
                await client.recv()
        assert (server.url, server.bridge.subscribed()) == (url, set())
        async with connect(url) as again:
            await send(again, "subscribe", topic="/robot_0/queue", type="oh_ressources/msg/ActionQueue")
            assert (await read(again))["msg"]["last_order_id"] == 1


class TestSizes:
    async def test_fragments_as_recorded(self, client: ClientConnection) -> None:
        lines = recording("ros2-fragments.jsonl.gz")
        asked = json.loads(theirs(frames(lines, "out")[0]).replace("robot_1", "robot_0"))
        await client.send(json.dumps(asked))
        first = await read(client)
        rest = [await read(client) for _ in range(first["total"] - 1)]
        recorded = parsed(frames(lines, "in")[0])
        assert shape(first) == shape(recorded)
        assert (first["id"], first["num"], len(first["data"])) == (recorded["id"], 0, asked["fragment_size"])
        whole = json.loads("".join(frame["data"] for frame in (first, *rest)))
        assert whole["topic"] == GRAPH and len(whole["msg"]["vertices"]) == 20
        await send(client, "call_service", id="t", service="/rosapi/topics")
        answer = await read(client)
        assert (answer["op"], answer["id"]) == ("fragment", "t")

    async def test_a_call_may_ask_for_fragments_too(self, client: ClientConnection) -> None:
        await send(client, "call_service", id="t", service="/rosapi/topics", fragment_size=100)
        answer = await read(client)
        assert (answer["op"], answer["id"], len(answer["data"])) == ("fragment", "t", 100)

    async def test_above_the_bridges_limit_text_is_cut_and_cbor_never_comes(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.max_message_size = 1000
        topic = "/robot_0/floor_0/map"
        await send(client, "subscribe", topic="/rosout")
        await send(client, "subscribe", topic=topic, compression="cbor")
        line = (await read_until(client, lambda frame: "max_message_size" in str(frame)))[-1]
        assert '"level":40' in line["data"] and line["total"] > 900, "all of the map is in the log"
        await send(client, "unsubscribe", topic=topic)
        await send(client, "subscribe", topic=topic)
        await read_until(client, lambda frame: frame["num"] == line["total"] - 1)
        first = (
            await read_until(client, lambda frame: frame["op"] == "fragment" and "map" in frame["data"])
        )[-1]
        assert first["total"] > 900 and len(first["data"]) == 1000

    async def test_a_client_may_send_in_fragments(self, client: ClientConnection) -> None:
        text = json.dumps({"op": "call_service", "id": "p", "service": PAUSE})
        for number in (1, 0):
            data = text[number * 20 : 20 if number == 0 else None]
            await send(client, "fragment", id="f", data=data, num=number, total=2)
        assert (await until_answer(client, "p"))["result"]


async def test_silent_failures_are_lines_of_rosout(client: ClientConnection) -> None:
    await send(client, "subscribe", topic="/rosout")
    await send(client, "subscribe", id="mine", topic="/robot_0/pose", type="std_msgs/msg/String")
    line = (await read_until(client, lambda frame: frame["msg"]["level"] == 40))[-1]["msg"]
    assert line["name"] == "rosbridge_websocket"
    assert "[id: mine] subscribe: " in line["msg"] and "/robot_0/pose" in line["msg"]


async def test_a_late_subscriber_of_rosout_hears_what_was_said(client: ClientConnection) -> None:
    for op in ("subscribe", "unsubscribe"):
        await send(client, op, topic="/robot_0/map")
    await send(client, "subscribe", topic=GRAPH)
    await send(client, "subscribe", topic="/rosout")
    lines = await read_until(client, lambda frame: "to /rosout" in frame["msg"].get("msg", ""))
    texts = [line["msg"]["msg"].partition("] ")[2] for line in lines if line["topic"] == "/rosout"]
    assert texts == [
        "subscribe: Cannot infer topic type for topic /robot_0/map as it is not yet advertised",
        f"Subscribed to {GRAPH}",
        "Subscribed to /rosout",
    ]


async def test_broken_frames_do_no_harm(client: ClientConnection) -> None:
    for text in frames(recording("ros2-badjson.jsonl.gz"), "out"):
        if not text.endswith("}"):
            await client.send(text)
    await client.send(json.dumps({"op": "call_service", "id": "p", "service": PAUSE}).encode())
    assert (await until_answer(client, "p"))["result"]
    await client.send(b"\xff\xfe")
    with pytest.raises(ConnectionClosed):
        await client.recv()


async def test_what_is_published_is_completed_as_recorded(client: ClientConnection) -> None:
    """The recorded robots say in words what they heard; here another client hears it itself."""
    types = {"goal_pose": "PoseStamped", "initialpose": "PoseWithCovarianceStamped", "cmd_vel": "Twist"}
    for name, type_ in types.items():
        await send(client, "subscribe", topic=f"/tb3/{name}", type=f"geometry_msgs/msg/{type_}")
    subscriptions: dict[str, list[Json]] = {f"/tb3/{name}": [] for name in types}
    for text in frames(recording("ros2-publish.jsonl.gz"), "out"):
        if parsed(text)["op"] != "subscribe":
            await client.send(text)
    while sum(map(len, subscriptions.values())) < 7:
        frame = await read(client)
        subscriptions[frame["topic"]].append(frame["msg"])
    assert await frames_before_an_answer(client) == []  # the null and the seq are refused
    assert subscriptions["/tb3/cmd_vel"][0]["angular"] == {"x": 0.0, "y": 0.0, "z": 0.0}
    first, *_, last = subscriptions["/tb3/goal_pose"]
    assert first["header"]["stamp"]["sec"] > 0
    assert last["header"]["stamp"] == {"sec": 5, "nanosec": 6}
    assert last["pose"]["orientation"]["w"] == 1.0
    assert [msg["pose"]["covariance"][:2] for msg in subscriptions["/tb3/initialpose"]] == [
        [0.25, 0.0],
        [0.25, 0.25],
        [0.0, 0.0],
    ]


async def test_diagnostics_never_come_as_cbor(server: RosbridgeServer, client: ClientConnection) -> None:
    await send(client, "subscribe", topic="/diagnostics", compression="cbor")
    await send(client, "subscribe", topic="/robot_0/pose")
    for _ in range(25):  # more than a second of poses
        assert (await read(client))["topic"] == "/robot_0/pose"
