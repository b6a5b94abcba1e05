"""Messages as frames: JSON, PNG and CBOR."""

import base64
import io
import json
import math

import cbor2
from PIL import Image
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import frames_before_an_answer, read, read_until, send, subscribe

MAP, MAP_TYPE = "/robot_0/floor_0/map", "nav_msgs/OccupancyGrid"


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
