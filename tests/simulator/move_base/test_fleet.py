"""Goals through a bridge of ROS 1, and what other clients see and may do of them."""

import asyncio
import json
import time

import cbor2
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


async def heard(client: ClientConnection, topic: str) -> Json:
    await listen(client, topic)
    frame = await until(client, lambda frame: frame.get("topic") == topic)
    message: Json = frame["msg"]
    return message


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


async def test_the_status_is_a_heartbeat_even_without_goals(client: ClientConnection) -> None:
    await listen(client, STATUS)
    frames = list[Json]()
    while len(frames) < 6:
        frames.append(json.loads(await client.recv()))
    assert {len(frame["msg"]["status_list"]) for frame in frames} == {0}
    counted = [frame["msg"]["header"]["seq"] for frame in frames]
    assert counted == list(range(counted[0], counted[0] + 6))
    first, last = (frame["msg"]["header"]["stamp"] for frame in (frames[0], frames[-1]))
    assert 0.9 < last["secs"] - first["secs"] + (last["nsecs"] - first["nsecs"]) * 1e-9 < 3.0


async def test_a_late_client_is_told_the_last_status_at_once(
    server: RosbridgeServer, client: ClientConnection, other: ClientConnection
) -> None:
    await listen(other, RESULT)
    await settle(other)
    await give(client, "a", NEAR)
    await result(other, "a")
    await settle(other)
    server.speed = 0.0
    for robot in server.bridge.services.robots.values():
        robot.silence = 0.0
    await listen(client, STATUS)
    assert listed(json.loads(await client.recv())) == {"a": 3}
    await listen(client, RESULT)  # not latched
    await settle(client)


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


async def test_what_has_the_wrong_type_or_field_is_not_taken(
    client: ClientConnection, other: ClientConnection, fleet: MoveBaseFleet
) -> None:
    await publish(client, GOAL, {"goal": {"pose": NEAR}})
    await client.send(json.dumps({"op": "publish", "topic": GOAL, "type": "std_msgs/String", "msg": {}}))
    broken = pose(8.0, 0.0) | {"header": {"frame_id": None}}
    await give(client, "a", broken)
    await settle(client)
    assert not fleet.navigation["robot_0"].received


async def test_telemetry_is_ros_1s(client: ClientConnection) -> None:
    odometry = await heard(client, "/robot_0/odom")
    assert odometry["header"].keys() == HEADER.keys() and odometry["header"]["frame_id"] == "robot_0/odom"
    assert odometry["pose"]["covariance"][21] is None and len(odometry["pose"]["covariance"]) == 36
    again = (await until(client, lambda frame: frame["topic"] == "/robot_0/odom"))["msg"]
    assert again["header"]["seq"] == odometry["header"]["seq"] + 1
    where = await heard(client, "/robot_0/amcl_pose")
    assert shape(where) == {"header": HEADER, "pose": {"pose": POSE, "covariance": [float]}}
    assert where["header"]["frame_id"] == "map"
    battery = await heard(client, "/robot_0/battery_state")
    assert 0.4 < battery["percentage"] < 1.0 and battery["current"] is None
    picture = await heard(client, "/map")
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


async def test_amcl_speaks_only_after_a_distance(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet
) -> None:
    server.speed = 1.0
    await listen(client, "/robot_0/amcl_pose")
    first = json.loads(await client.recv())["msg"]
    await settle(client)
    fleet.navigation["robot_0"].give(35.0, 20.0)
    second = json.loads(await client.recv())["msg"]
    assert second["header"]["seq"] == first["header"]["seq"] + 1


async def test_rosapi_tells_the_action_its_topics_and_types(client: ClientConnection) -> None:
    assert await call(client, "/rosapi/action_servers") == {
        "action_servers": ["/robot_0/move_base", "/robot_1/move_base"]
    }
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


async def test_several_floors_have_a_map_each_and_robots_tell_theirs() -> None:
    server = RosbridgeServer(MoveBaseFleet(2, 2, seed=1, quiet=True))
    types = server.bridge.services.types
    assert types["/floor_1/map"] == "nav_msgs/OccupancyGrid" and "/map" not in types
    assert json.loads(server.bridge.topics["/robot_1/floor"].payload(0.0).json) == {"data": "floor_1"}


async def test_a_reason_is_a_line_of_the_log(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, "/rosout")
    await settle(other)
    await give(client, "a", pose(8.0, 0.0, frame="odom"))
    async with asyncio.timeout(5):
        line = await until(other, lambda frame: frame["topic"] == "/rosout" and "odom" in frame["msg"]["msg"])
    assert line["msg"]["name"] == BASE and line["msg"]["level"] == 4
