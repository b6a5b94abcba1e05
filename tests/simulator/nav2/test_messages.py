"""Messages of robots with Nav2, as recorded."""

import json

import pytest
from websockets.asyncio.client import ClientConnection

from tests.support.nav2_client import Json, listen
from tests.support.transcripts import frames, parsed, recording, shape


def ours(text: str) -> str:
    """The recording with our names for the robots."""
    return text.replace("/tb2/", "/robot_0/").replace("/tb3/", "/robot_1/").replace("/tb1/", "/robot_0/")


def recorded(name: str, op: str, id_: str) -> Json:
    lines = map(parsed, map(ours, (text.replace("\\/", "/") for text in frames(recording(name), "in"))))
    return next(frame for frame in lines if frame["op"] == op and frame.get("id", frame.get("topic")) == id_)


@pytest.mark.parametrize("topic", ["/robot_0/odom", "/robot_0/amcl_pose", "/robot_0/battery_state"])
async def test_telemetry_has_the_recorded_shape(client: ClientConnection, topic: str) -> None:
    wanted = recorded("ros2-topics.jsonl.gz", "publish", topic)
    await listen(client, topic)
    subscriptions = json.loads(await client.recv())
    assert shape(subscriptions["msg"]) == shape(wanted["msg"])
    assert list(subscriptions["msg"]) == list(wanted["msg"])
