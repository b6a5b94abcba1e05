"""What any client may do with the bridge beside watching robots, on ROS 1."""

import json
from typing import Any

import cbor2
import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.ros.definitions import MESSAGES, Fields
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.ros.filling import fill
from fleet_tui.simulator.ros.ros1 import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import call, frames_before_an_answer, read, send

Json = dict[str, Any]
POSE, MAP = "/robot_0/pose", "/robot_0/floor_0/map"


async def test_names_may_come_without_the_first_slash(client: ClientConnection) -> None:
    answer = await call(client, "rosapi/topic_type", {"topic": POSE})
    assert (answer["service"], answer["values"]) == (
        "rosapi/topic_type",
        {"type": "geometry_msgs/PoseStamped"},
    )
    await send(client, "subscribe", topic="robot_0/pose", type="geometry_msgs/PoseStamped")
    assert (await read(client))["topic"] == "robot_0/pose"


async def test_what_one_client_publishes_another_hears(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    async with connect(server.url) as other:
        await send(client, "advertise", topic="/chatter", type="std_msgs/String", latch=True)
        await send(client, "publish", topic="/chatter", msg={"data": "hello"})
        await send(client, "publish", topic="/chatter", msg={"data": 7})  # refused without a word
        assert await frames_before_an_answer(client) == []
        await send(other, "subscribe", topic="/chatter")
        assert (await read(other))["msg"] == {"data": "hello"}
        answer = await call(client, "/rosapi/publishers", {"topic": "/chatter"})
        assert answer["values"] == {"publishers": ["/rosbridge_websocket"]}
        await client.close()
        await send(other, "unsubscribe", topic="/chatter")
        while (await call(other, "/rosapi/topic_type", {"topic": "/chatter"}))["values"]["type"]:
            pass  # until the bridge has noticed


async def test_a_robots_topic_outlives_a_client_that_publishes_it_too(client: ClientConnection) -> None:
    await send(client, "advertise", topic="/robot_0/cargo", type="std_msgs/Bool")
    await send(client, "publish", topic="/robot_0/cargo", type="std_msgs/Bool", msg={"data": True})
    await send(client, "unadvertise", topic="/robot_0/cargo")
    answer = await call(client, "/rosapi/topic_type", {"topic": "/robot_0/cargo"})
    assert answer["values"] == {"type": "std_msgs/Bool"}
    await send(client, "subscribe", topic="/robot_0/cargo")
    assert (await read(client))["msg"] == {"data": False}


async def test_a_latched_topic_without_a_message_says_nothing(client: ClientConnection) -> None:
    await send(client, "advertise", topic="/chatter", type="std_msgs/String", latch=True)
    await send(client, "subscribe", topic="/chatter")
    assert await frames_before_an_answer(client) == []


async def test_what_one_client_offers_another_calls(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    async with connect(server.url) as other:
        await send(other, "advertise_service", service="/light", type="std_srvs/SetBool")
        await frames_before_an_answer(other)
        await send(client, "call_service", id="mine", service="/light", args={"data": True})
        asked = await read(other)
        assert (asked["op"], asked["service"], asked["args"]) == ("call_service", "/light", {"data": True})
        values = {"success": True, "message": "on"}
        response = {"service": "/light", "id": asked["id"], "values": values, "result": True}
        await send(other, "service_response", **response)
        answer = await read(client)
        assert (answer["id"], answer["values"], answer["result"]) == ("mine", values, True)
        answer = await call(client, "/light", {"dark": 1})
        assert answer["values"] == "Message type std_srvs/SetBoolRequest does not have a field dark"
        answer = await call(client, "/rosapi/services_for_type", {"type": "std_srvs/SetBool"})
        assert answer["values"] == {"services": ["/light"]}
        await send(other, "unadvertise_service", service="/light")
        await frames_before_an_answer(other)
        assert (await call(client, "/light"))["values"] == "Service /light does not exist"


async def test_a_wrong_type_before_the_publisher_poisons_the_topic_for_all(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    async with connect(server.url) as other, connect(server.url) as talker:
        await send(client, "subscribe", topic="/later", type="std_msgs/Bool")
        await frames_before_an_answer(client)
        await send(other, "subscribe", topic="/later", type="std_msgs/String")
        await send(talker, "advertise", topic="/later", type="std_msgs/String")
        await send(talker, "publish", topic="/later", msg={"data": "hello"})
        await frames_before_an_answer(talker)
        for each in (client, other):
            assert await frames_before_an_answer(each) == []
        await send(client, "unsubscribe", topic="/later")
        await frames_before_an_answer(client)
        await send(other, "subscribe", topic="/later", type="std_msgs/String")
        await frames_before_an_answer(other)
        await send(talker, "publish", topic="/later", msg={"data": "again"})
        assert (await read(other))["msg"] == {"data": "again"}


async def test_a_topic_with_only_subscribers_is_listed_without_a_publisher(client: ClientConnection) -> None:
    await send(client, "subscribe", topic="/later", type="std_msgs/Bool")
    topics = (await call(client, "/rosapi/topics"))["values"]
    assert dict(zip(topics["topics"], topics["types"], strict=True))["/later"] == "std_msgs/Bool"
    assert (await call(client, "/rosapi/publishers", {"topic": "/later"}))["values"] == {"publishers": []}


async def test_fragments_in_both_directions(client: ClientConnection) -> None:
    text = json.dumps({"op": "subscribe", "topic": "/robot_0/floor_0/graph", "fragment_size": 700})
    for number, data in enumerate((text[:10], text[10:])):
        await send(client, "fragment", id="whole", data=data, num=number, total=2)
    first = await read(client)
    assert (first["op"], first["id"], first["num"], len(first["data"])) == ("fragment", 0, 0, 700)
    parts = [first, *[await read(client) for _ in range(first["total"] - 1)]]
    assert len(json.loads("".join(part["data"] for part in parts))["msg"]["vertices"]) == 20


async def test_the_bridge_names_its_clients(server: RosbridgeServer, client: ClientConnection) -> None:
    await send(client, "subscribe", topic="/connected_clients")
    (one,) = (await read(client))["msg"]["clients"]
    assert one["ip_address"] == "127.0.0.1"
    assert list(one["connection_time"]) == ["secs", "nsecs"]
    async with connect(server.url):
        assert len((await read(client))["msg"]["clients"]) == 2


async def test_rosapi_keeps_params_and_tells_of_nodes(client: ClientConnection) -> None:
    await call(client, "/rosapi/set_param", {"name": "/speed", "value": "1.5"})
    assert (await call(client, "/rosapi/get_param", {"name": "/speed"}))["values"] == {"value": "1.5"}
    assert (await call(client, "/rosapi/has_param", {"name": "/speed"}))["values"] == {"exists": True}
    assert "/speed" in (await call(client, "/rosapi/get_param_names"))["values"]["names"]
    await call(client, "/rosapi/delete_param", {"name": "/speed"})
    assert (await call(client, "/rosapi/has_param", {"name": "/speed"}))["values"] == {"exists": False}
    details = (await call(client, "/rosapi/node_details", {"node": "/fleet"}))["values"]
    assert POSE in details["publishing"] and details["subscribing"] == []
    assert "/robot_0/Application_layout/Pause" in details["services"]
    raw = (await call(client, "/rosapi/topics_and_raw_types"))["values"]
    text = raw["typedefs_full_text"][raw["topics"].index("/robot_0/battery")]
    assert text == "float32 data"


@pytest.mark.parametrize(
    ("verb", "names"),
    [("request", ["request_id", "initial_point", "end_point"]), ("response", ["request_id", "status"])],
)
async def test_rosapi_describes_services(client: ClientConnection, verb: str, names: list[str]) -> None:
    args = {"type": "OH_ressources/Execute_manual_order"}
    (typedef,) = (await call(client, f"/rosapi/service_{verb}_details", args))["values"]["typedefs"]
    assert typedef["type"] == f"OH_ressources/Execute_manual_order{verb.capitalize()}"
    assert typedef["fieldnames"] == names
    assert typedef["fieldarraylen"] == [-1] * len(names)


async def test_rosapi_describes_a_message_and_all_in_it(client: ClientConnection) -> None:
    args = {"type": "OH_ressources/Graph"}
    graph, *parts = (await call(client, "/rosapi/message_details", args))["values"]["typedefs"]
    assert graph == {
        "type": "OH_ressources/Graph",
        "fieldnames": ["vertices", "edges"],
        "fieldtypes": ["OH_ressources/Vertex", "OH_ressources/Edge"],
        "fieldarraylen": [0, 0],
        "examples": ["[]", "[]"],
        "constnames": [],
        "constvalues": [],
    }
    assert [part["type"] for part in parts] == ["OH_ressources/Vertex", "OH_ressources/Edge"]


def definition(fields: Fields) -> str:
    """The lines of a .msg file."""
    length = {key: "" if field.length is None else f"[{field.length or ''}]" for key, field in fields.items()}
    return "\n".join(
        f"{field.type}{length[key]} {key}".replace("OH_", "oh_") for key, field in fields.items()
    )


def bag_type(short: str) -> str:
    """The library's name of a type: no capital letters in a package."""
    return short.replace("OH_", "oh_").replace("/", "/msg/")


@pytest.mark.parametrize(("dialect", "store"), [(ROS1, Stores.ROS1_NOETIC), (ROS2, Stores.ROS2_JAZZY)])
def test_every_message_is_encoded_as_ros_reads_it(dialect: Dialect, store: Stores) -> None:
    """Against an implementation of others: a bag library reads what was encoded, and writes it the same."""
    types = get_typestore(store)
    shorts = {dialect.short(dialect.message_type(name)) for name in MESSAGES}
    messages = {short: fields for short in shorts if (fields := dialect.fields(short)) is not None}
    for short, fields in messages.items():
        type_ = bag_type(short)
        if type_ not in types.types:
            types.register(get_types_from_msg(definition(fields), type_))
    order = {"id": 7, "start": 1, "end": 2, "status": "W"}
    for short, fields in messages.items():
        given = {"orders": [order, order]} if short.endswith("ActionQueue") else {}
        data = encode(dialect, short, fill(dialect, short, fields, given, now=1.5))
        type_ = bag_type(short)
        if dialect.version == 1:
            assert bytes(types.serialize_ros1(types.deserialize_ros1(data, type_), type_)) == data, short
        else:
            assert bytes(types.serialize_cdr(types.deserialize_cdr(data, type_), type_)) == data, short


async def test_cbor_raw_carries_the_map_as_ros_encodes_it(client: ClientConnection) -> None:
    await send(client, "subscribe", topic=MAP, compression="cbor-raw")
    frame = cbor2.loads(bytes(await client.recv(decode=False)))
    assert list(frame["msg"]) == ["secs", "nsecs", "bytes"]
    types = get_typestore(Stores.ROS1_NOETIC)
    grid = types.deserialize_ros1(frame["msg"]["bytes"], "nav_msgs/msg/OccupancyGrid")
    assert (grid.info.width, grid.info.height, len(grid.data)) == (800, 520, 800 * 520)  # type: ignore[attr-defined]  # made at run time


async def test_the_world_runs_faster_and_the_wire_does_not() -> None:
    server = RosbridgeServer(World(1, 1, seed=1, quiet=True), rate=20.0, speed=30.0)
    robot = server.world.robots["robot_0"]
    robot.take(19, 0, request_id=1)
    await server.start()
    async with connect(server.url) as client:
        await send(client, "subscribe", topic=POSE)
        stamps = [(await read(client))["msg"]["header"]["stamp"] for _ in range(5)]
        gone = server.world.time
        while robot.orders:  # it takes more than a minute of the robot's time
            await read(client)
    await server.stop()
    seconds = [stamp["secs"] + stamp["nsecs"] / 1e9 for stamp in stamps]
    assert seconds[-1] - seconds[0] > 0.1
    assert gone > 5 * 20 * (seconds[-1] - seconds[0]) / 5 > 0
    assert server.world.time > 60.0
