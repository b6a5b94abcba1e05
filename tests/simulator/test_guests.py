"""Topics and services of clients: published, offered and gone with them."""

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import call, frames_before_an_answer, read, send


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
        assert answer["values"] == {"services": ["/robot_0/set_mapping", "/robot_1/set_mapping", "/light"]}
        await send(other, "unadvertise_service", service="/light")
        await frames_before_an_answer(other)
        assert (await call(client, "/light"))["values"] == "Service /light does not exist"
