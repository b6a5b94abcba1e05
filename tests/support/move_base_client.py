"""A client of robots with move_base: how it asks, and what it understands."""

import json
import math
from typing import Any

from websockets.asyncio.client import ClientConnection

from tests.support.nav2_client import Json, until

BASE = "/robot_0/move_base"
GOAL, CANCEL, STATUS, RESULT, FEEDBACK = (
    f"{BASE}/{part}" for part in ("goal", "cancel", "status", "result", "feedback")
)
TYPES = {GOAL: "move_base_msgs/MoveBaseActionGoal", CANCEL: "actionlib_msgs/GoalID"}
NEVER: Json = {"secs": 0, "nsecs": 0}


def pose(x: float, y: float, yaw: float = 0.0, frame: str = "map") -> Json:
    turn = {"x": 0.0, "y": 0.0, "z": math.sin(yaw / 2), "w": math.cos(yaw / 2)}
    position = {"x": x, "y": y, "z": 0.0}
    return {"header": {"frame_id": frame}, "pose": {"position": position, "orientation": turn}}


def goal(id_: str, target: Json, stamp: Json = NEVER) -> Json:
    return {"goal_id": {"stamp": stamp, "id": id_}, "goal": {"target_pose": target}}


async def publish(client: ClientConnection, topic: str, msg: Json) -> None:
    sent = {"op": "publish", "topic": topic, "msg": msg}
    await client.send(json.dumps(sent | ({"type": TYPES[topic]} if topic in TYPES else {})))


async def give(client: ClientConnection, id_: str, target: Json, stamp: Json = NEVER) -> None:
    await publish(client, GOAL, goal(id_, target, stamp))


async def cancel(client: ClientConnection, id_: str = "", stamp: Json = NEVER) -> None:
    await publish(client, CANCEL, {"stamp": stamp, "id": id_})


async def result(client: ClientConnection, id_: str) -> tuple[int, str]:
    """The status and the text with which a goal ended."""
    frame = await until(
        client, lambda frame: frame.get("topic") == RESULT and frame["msg"]["status"]["goal_id"]["id"] == id_
    )
    return frame["msg"]["status"]["status"], frame["msg"]["status"]["text"]


def listed(frame: Json) -> dict[str, int]:
    """The goals of a message of the status topic."""
    found: list[Any] = frame["msg"]["status_list"]
    return {one["goal_id"]["id"]: one["status"] for one in found}


async def told(client: ClientConnection, wanted: dict[str, int]) -> Json:
    """The next message of the status topic that lists exactly these goals."""
    return await until(client, lambda frame: frame.get("topic") == STATUS and listed(frame) == wanted)
