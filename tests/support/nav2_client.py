"""A client of robots with Nav2: how it asks, and how it waits."""

import json
from collections.abc import Callable
from typing import Any

from websockets.asyncio.client import ClientConnection

Json = dict[str, Any]

TO_POSE, WAYPOINTS = "/robot_0/navigate_to_pose", "/robot_0/follow_waypoints"
TYPES = {TO_POSE: "nav2_msgs/action/NavigateToPose", WAYPOINTS: "nav2_msgs/action/FollowWaypoints"}
ZERO = "AAAAAAAAAAAAAAAAAAAAAA=="


def pose(x: float, y: float, frame: str = "map") -> Json:
    turn = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
    return {
        "header": {"frame_id": frame},
        "pose": {"position": {"x": x, "y": y, "z": 0.0}, "orientation": turn},
    }


async def give(client: ClientConnection, id_: str, action: str, **args: Any) -> None:
    sent = {"op": "send_action_goal", "id": id_, "action": action, "action_type": TYPES[action]}
    await client.send(json.dumps(sent | {"args": args}))


async def listen(client: ClientConnection, topic: str) -> None:
    await client.send(json.dumps({"op": "subscribe", "topic": topic}))


async def settle(client: ClientConnection) -> None:
    """Wait until everything that was sent before has been read."""
    await client.send('{"op":"call_service","id":"settled","service":"/no/such"}')
    await until(client, lambda frame: frame.get("id") == "settled")


async def call(client: ClientConnection, service: str, **args: Any) -> Any:
    await client.send(json.dumps({"op": "call_service", "id": service, "service": service, "args": args}))
    answer = await until(client, lambda frame: frame.get("id") == service)
    return answer["values"]


async def until(client: ClientConnection, wanted: Callable[[Json], object]) -> Json:
    """The next frame of which this is true."""
    while True:
        frame = json.loads(await client.recv())
        if wanted(frame):
            assert isinstance(frame, dict)
            return frame


async def latest(client: ClientConnection, topic: str) -> Any:
    """The first message of a topic after subscribing to it."""
    await listen(client, topic)
    return (await until(client, lambda frame: frame.get("topic") == topic))["msg"]


async def result(client: ClientConnection, id_: str) -> Json:
    """The end of a goal of this client."""
    return await until(client, lambda frame: frame["op"] == "action_result" and frame["id"] == id_)


def statuses(frame: Json) -> list[int]:
    """The statuses that a frame of a status topic tells."""
    return [one["status"] for one in frame["msg"]["status_list"]]
