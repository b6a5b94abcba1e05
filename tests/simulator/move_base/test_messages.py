"""Messages of move_base, as ROS 1 has them."""

import json

import cbor2
import pytest
from websockets.asyncio.client import ClientConnection

from tests.support.move_base_client import STATUS
from tests.support.nav2_client import Json, listen, until

STAMP = {"secs": int, "nsecs": int}
HEADER = {"seq": int, "stamp": STAMP, "frame_id": str}
POSE = {
    "position": {"x": float, "y": float, "z": float},
    "orientation": {"x": float, "y": float, "z": float, "w": float},
}


def shape(value: object) -> object:
    if isinstance(value, dict):
        return {name: shape(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [shape(inner) for inner in value[:1]]
    return type(value)


async def subscriptions(client: ClientConnection, topic: str) -> Json:
    await listen(client, topic)
    frame = await until(client, lambda frame: frame.get("topic") == topic)
    message: Json = frame["msg"]
    return message


async def test_telemetry_is_ros_1s(client: ClientConnection) -> None:
    odometry = await subscriptions(client, "/robot_0/odom")
    assert odometry["header"].keys() == HEADER.keys() and odometry["header"]["frame_id"] == "robot_0/odom"
    assert odometry["pose"]["covariance"][21] is None and len(odometry["pose"]["covariance"]) == 36
    again = (await until(client, lambda frame: frame["topic"] == "/robot_0/odom"))["msg"]
    assert again["header"]["seq"] == odometry["header"]["seq"] + 1
    where = await subscriptions(client, "/robot_0/amcl_pose")
    assert shape(where) == {"header": HEADER, "pose": {"pose": POSE, "covariance": [float]}}
    assert where["header"]["frame_id"] == "map"
    battery = await subscriptions(client, "/robot_0/battery_state")
    assert 0.4 < battery["percentage"] < 1.0 and battery["current"] is None
    picture = await subscriptions(client, "/map")
    assert picture["info"]["map_load_time"].keys() == STAMP.keys()


@pytest.mark.parametrize("compression", ["cbor", "cbor-raw"])
async def test_telemetry_comes_in_binary_too(client: ClientConnection, compression: str) -> None:
    for topic in ("/robot_0/odom", "/robot_0/amcl_pose", STATUS):
        await client.send(json.dumps({"op": "subscribe", "topic": topic, "compression": compression}))
    seen = dict[str, Json]()
    while len(seen) < 3:
        frame = cbor2.loads(await client.recv(decode=False))
        seen[frame["topic"]] = frame["msg"]
    if compression == "cbor":
        assert len(seen["/robot_0/odom"]["pose"]["covariance"]) == 36
    else:
        # A header of 4 + 8 bytes with an empty frame, and an empty list.
        assert len(seen[STATUS]["bytes"]) == 20
