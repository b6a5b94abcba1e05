"""Goals through a bridge of ROS 1, and what other clients see and may do of them."""

import asyncio
import json
import time

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.move_base.navigation import INVALID, NO_PLAN, REACHED
from fleet_tui.simulator.ros.actionlib import REPLACED
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.move_base_client import (
    BASE,
    CANCEL,
    FEEDBACK,
    GOAL,
    RESULT,
    STATUS,
    cancel,
    give,
    listed,
    pose,
    publish,
    result,
    told,
)
from tests.support.nav2_client import Json, call, listen, settle, until
from tests.support.polling import HANGS

FAR, NEAR = pose(35.0, 20.0), pose(8.0, 0.0)
STAMP = {"secs": int, "nsecs": int}
HEADER = {"seq": int, "stamp": STAMP, "frame_id": str}
GOAL_STATUS = {"goal_id": {"stamp": STAMP, "id": str}, "status": int, "text": str}
POSE = {
    "position": {"x": float, "y": float, "z": float},
    "orientation": {"x": float, "y": float, "z": float, "w": float},
}
STAMPED = {"header": HEADER, "pose": POSE}


def shape(value: object) -> object:
    if isinstance(value, dict):
        return {name: shape(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [shape(inner) for inner in value[:1]]
    return type(value)


async def test_a_goal_is_told_from_its_coming_to_its_end(
    server: RosbridgeServer, client: ClientConnection, other: ClientConnection
) -> None:
    server.speed = 5.0
    for part in (STATUS, RESULT, FEEDBACK, f"{BASE}/current_goal", f"{BASE}/NavfnROS/plan"):
        await listen(other, part)
    await settle(other)
    await give(client, "fleet-tui-1", pose(8.0, 0.0, 1.0))
    seen: dict[str, Json] = {}
    while RESULT not in seen:
        frame = json.loads(await other.recv())
        seen[frame["topic"]] = frame["msg"]
        if frame["topic"] == FEEDBACK:
            assert frame["msg"]["status"]["status"] == 1
    status = seen[RESULT]["status"]
    assert (status["goal_id"]["id"], status["status"], status["text"]) == ("fleet-tui-1", 3, REACHED)
    assert time.time() - status["goal_id"]["stamp"]["secs"] < 60.0
    assert shape(seen[RESULT]) == {"header": HEADER, "status": GOAL_STATUS, "result": {}}
    assert shape(seen[STATUS]) == {"header": HEADER, "status_list": [GOAL_STATUS]}
    assert shape(seen[FEEDBACK]) == {
        "header": HEADER,
        "status": GOAL_STATUS,
        "feedback": {"base_position": STAMPED},
    }
    assert seen[FEEDBACK]["feedback"]["base_position"]["header"]["frame_id"] == "map"
    assert shape(seen[f"{BASE}/current_goal"]) == STAMPED
    assert shape(seen[f"{BASE}/NavfnROS/plan"]) == {"header": HEADER, "poses": [STAMPED]}
    assert seen[f"{BASE}/NavfnROS/plan"]["poses"][-1]["pose"]["position"]["x"] == 8.0
    await told(other, {"fleet-tui-1": 3})


async def test_a_newer_goal_preempts_and_is_reached(
    client: ClientConnection, other: ClientConnection
) -> None:
    await listen(other, RESULT)
    await listen(other, STATUS)
    await settle(other)
    await give(client, "a", FAR)
    await told(other, {"a": 1})
    await give(client, "b", NEAR)
    assert await result(other, "a") == (2, REPLACED)
    assert await result(other, "b") == (3, REACHED)


async def test_anyone_cancels_by_id_alone(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, STATUS)
    await settle(other)
    await give(client, "a", FAR)
    await told(other, {"a": 1})
    await cancel(other, "b")
    await told(other, {"a": 1, "b": 7})
    await cancel(other, "a")
    await told(other, {"a": 6, "b": 7})
    await told(other, {"a": 2, "b": 7})


@pytest.mark.parametrize("args", [{}, {"id": ""}, {"stamp": {"secs": 0, "nsecs": 0}}])
async def test_what_is_left_out_of_a_cancel_is_zero_and_means_all(
    client: ClientConnection, other: ClientConnection, args: Json
) -> None:
    await listen(other, RESULT)
    await settle(other)
    await give(client, "a", FAR)
    await publish(client, CANCEL, args)
    assert await result(other, "a") == (2, "")


async def test_a_stamp_cancels_every_goal_up_to_it(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, STATUS)
    await settle(other)
    await give(client, "a", FAR)
    await told(other, {"a": 1})
    await cancel(client, "", {"secs": 1, "nsecs": 0})
    await settle(client)
    await cancel(client, "x", {"secs": int(time.time()) + 60, "nsecs": 0})
    await told(other, {"a": 2, "x": 7})


async def test_a_cancel_before_its_goal_recalls_it(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, RESULT)
    await settle(other)
    await cancel(client, "a")
    await give(client, "a", FAR)
    assert await result(other, "a") == (8, "")


async def test_bad_goals_are_aborted_with_their_reasons(
    client: ClientConnection, other: ClientConnection
) -> None:
    await listen(other, RESULT)
    await settle(other)
    target = pose(8.0, 0.0)
    del target["pose"]["orientation"]  # on ROS 1 what is missing is a quaternion of zeros
    await give(client, "turn", target)
    assert await result(other, "turn") == (4, INVALID)
    await give(client, "off", pose(-99.0, 0.0))
    assert await result(other, "off") == (4, NO_PLAN)


async def test_a_known_id_is_ignored(
    server: RosbridgeServer, client: ClientConnection, other: ClientConnection, fleet: MoveBaseFleet
) -> None:
    for topic in (RESULT, f"{BASE}/current_goal"):
        await listen(other, topic)
    await settle(other)
    await give(client, "a", NEAR)
    assert await result(other, "a") == (3, REACHED)
    await give(client, "a", FAR)
    await settle(client)
    await give(client, "b", NEAR)
    frame = await until(other, lambda frame: frame["topic"].endswith("current_goal"))
    assert frame["msg"]["pose"]["position"]["x"] == 8.0
    assert len(fleet.navigation["robot_0"].received) == 3


async def test_a_pose_alone_becomes_a_goal_that_others_see(
    client: ClientConnection, other: ClientConnection
) -> None:
    for topic in (GOAL, RESULT, STATUS):
        await listen(other, topic)
    await settle(other)
    await publish(client, f"{BASE}_simple/goal", NEAR)
    seen = (await until(other, lambda frame: frame["topic"] == GOAL))["msg"]
    assert seen["goal_id"]["id"] == "" and seen["goal"]["target_pose"]["pose"]["position"]["x"] == 8.0
    frame = await until(other, lambda frame: frame["topic"] == STATUS and listed(frame))
    (id_,) = listed(frame)
    name, number, stamp = id_.rsplit("-", 2)
    assert (name, number) == (BASE, "1") and all(part.isdigit() for part in stamp.split("."))
    assert await result(other, id_) == (3, REACHED)


async def test_a_goal_is_echoed_with_a_number_and_without_a_time(
    client: ClientConnection, other: ClientConnection
) -> None:
    for topic in (GOAL, f"{BASE}/current_goal"):
        await listen(other, topic)
    await settle(other)
    for number, id_ in ((1, "a"), (2, "b")):
        untimed = {"stamp": {"secs": 0, "nsecs": 0}}
        goal = {"header": untimed, "goal_id": {**untimed, "id": id_}, "goal": {"target_pose": NEAR}}
        await publish(client, GOAL, goal)
        echo = (await until(other, lambda frame: frame["topic"] == GOAL))["msg"]
        assert echo["header"] == {"seq": number, "stamp": {"secs": 0, "nsecs": 0}, "frame_id": ""}
        assert echo["goal_id"] == {"stamp": {"secs": 0, "nsecs": 0}, "id": id_}
        begun = (await until(other, lambda frame: frame["topic"].endswith("current_goal")))["msg"]
        assert begun["header"]["seq"] == number - 1


async def test_what_has_the_wrong_type_or_field_is_not_taken(
    client: ClientConnection, other: ClientConnection, fleet: MoveBaseFleet
) -> None:
    await publish(client, GOAL, {"goal": {"pose": NEAR}})
    await client.send(json.dumps({"op": "publish", "topic": GOAL, "type": "std_msgs/String", "msg": {}}))
    broken = pose(8.0, 0.0) | {"header": {"frame_id": None}}
    await give(client, "a", broken)
    await settle(client)
    assert not fleet.navigation["robot_0"].received


async def test_rosapi_tells_the_action_its_topics_and_types(client: ClientConnection) -> None:
    assert await call(client, "/rosapi/action_servers") == {"action_servers": []}, "as the real one says"
    topics = await call(client, "/rosapi/topics")
    types = dict(zip(topics["topics"], topics["types"], strict=True))
    assert types[STATUS] == "actionlib_msgs/GoalStatusArray"
    assert types[CANCEL] == "actionlib_msgs/GoalID" and types[GOAL] == "move_base_msgs/MoveBaseActionGoal"
    assert types["/robot_0/battery_state"] == "sensor_msgs/BatteryState"
    for topic in (GOAL, CANCEL, f"{BASE}_simple/goal"):
        assert await call(client, "/rosapi/subscribers", topic=topic) == {"subscribers": ["/fleet"]}
    details = await call(client, "/rosapi/message_details", type="actionlib_msgs/GoalStatus")
    constants = dict(
        zip(details["typedefs"][0]["constnames"], details["typedefs"][0]["constvalues"], strict=True)
    )
    assert (constants["PREEMPTED"], constants["RECALLED"]) == ("2", "8")
    assert await call(client, f"{BASE}/clear_costmaps") == {}


async def test_a_reason_is_a_line_of_the_log(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, "/rosout")
    await settle(other)
    await give(client, "a", pose(8.0, 0.0, frame="odom"))
    async with asyncio.timeout(HANGS):
        line = await until(other, lambda frame: frame["topic"] == "/rosout" and "odom" in frame["msg"]["msg"])
    assert line["msg"]["name"] == BASE and line["msg"]["level"] == 4
