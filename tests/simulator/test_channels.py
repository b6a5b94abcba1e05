"""Subscriptions of the bridge, one for each topic."""

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import call, frames_before_an_answer, read, send

POSE, MAP = "/robot_0/pose", "/robot_0/floor_0/map"


async def test_names_may_come_without_the_first_slash(client: ClientConnection) -> None:
    answer = await call(client, "rosapi/topic_type", {"topic": POSE})
    assert (answer["service"], answer["values"]) == (
        "rosapi/topic_type",
        {"type": "geometry_msgs/PoseStamped"},
    )
    await send(client, "subscribe", topic="robot_0/pose", type="geometry_msgs/PoseStamped")
    assert (await read(client))["topic"] == "robot_0/pose"


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
