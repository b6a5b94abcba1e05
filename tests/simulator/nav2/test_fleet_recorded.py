"""Robots with Nav2 against recordings of a real bridge on ROS 2: the same frames in the same order."""

import json

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from tests.support.nav2_client import Json, listen, result, settle, statuses, until
from tests.support.transcripts import frames, parsed, recording, shape, until_answer

STATUS, FEEDBACK = (f"/robot_0/navigate_to_pose/_action/{part}" for part in ("status", "feedback"))


ACTIONS = "ros2-actions.jsonl.gz"


def ours(text: str) -> str:
    """The recording with our names for the robots."""
    return text.replace("/tb2/", "/robot_0/").replace("/tb3/", "/robot_1/").replace("/tb1/", "/robot_0/")


def far(text: str) -> str:
    """A goal with a target that takes a while to reach on our map."""
    operation = parsed(text)
    operation["args"]["pose"]["pose"]["position"] |= {"x": 17.0, "y": 20.0}
    return json.dumps(operation)


def recorded(name: str, op: str, id_: str) -> Json:
    lines = map(parsed, map(ours, (text.replace("\\/", "/") for text in frames(recording(name), "in"))))
    return next(frame for frame in lines if frame["op"] == op and frame.get("id", frame.get("topic")) == id_)


def sent(id_: str) -> str:
    return next(ours(text) for text in frames(recording(ACTIONS), "out") if parsed(text).get("id") == id_)


@pytest.mark.parametrize("goal", ["g4", "g5", "g6", "g6c", "g7", "g8"])
async def test_goals_that_come_to_nothing_are_answered_as_recorded(
    client: ClientConnection, goal: str
) -> None:
    await client.send(sent(goal))
    assert await result(client, goal) == recorded(ACTIONS, "action_result", goal)


async def test_a_goal_without_type_is_never_answered(client: ClientConnection) -> None:
    await client.send(sent("g9"))
    await client.send('{"op":"cancel_action_goal","id":"nope","action":"/robot_0/navigate_to_pose"}')
    await client.send(sent("g8"))
    assert json.loads(await client.recv())["id"] == "g8"


async def test_a_goal_is_driven_and_told_as_recorded(
    client: ClientConnection, other: ClientConnection, fleet: Nav2Fleet
) -> None:
    for topic in (STATUS, FEEDBACK):
        await listen(other, topic)
    await settle(other)
    await client.send(sent("g1"))
    feedback = json.loads(await client.recv())
    wanted = recorded(ACTIONS, "action_feedback", "g1")
    assert shape(feedback) == shape(wanted) and list(feedback) == list(wanted)
    assert list(feedback["values"]) == list(wanted["values"])
    assert await result(client, "g1") == recorded(ACTIONS, "action_result", "g1")
    robot = fleet.robots["robot_0"]
    assert (robot.pose.x, robot.pose.y, robot.pose.yaw) == pytest.approx((8.0, 3.0, 0.0))
    told = [json.loads(await other.recv()) for _ in range(4)]
    seen = [frame for frame in told if frame["topic"] == STATUS]
    assert [statuses(frame) for frame in seen[:2]] == [[1], [2]]
    assert shape(seen[0]) == shape(recorded("ros2-actions-observer.jsonl.gz", "publish", STATUS))
    progress = next(frame for frame in told if frame["topic"] == FEEDBACK)
    assert shape(progress) == shape(recorded("ros2-actions-observer.jsonl.gz", "publish", FEEDBACK))
    assert progress["msg"]["goal_id"] == seen[0]["msg"]["status_list"][0]["goal_info"]["goal_id"]
    await until(other, lambda frame: frame["topic"] == STATUS and statuses(frame) == [4])


async def test_a_goal_is_cancelled_as_recorded(client: ClientConnection, other: ClientConnection) -> None:
    await listen(other, STATUS)
    await settle(other)
    await client.send(far(sent("g10")))
    await until(other, lambda frame: statuses(frame) == [2])
    await client.send('{"op":"cancel_action_goal","id":"g10","action":"/robot_0/navigate_to_pose"}')
    assert await result(client, "g10") == {**recorded(ACTIONS, "action_result", "g2"), "id": "g10"}
    assert statuses(json.loads(await other.recv())) == [3]
    assert statuses(json.loads(await other.recv())) == [5]


async def test_rosapi_hides_what_actions_consist_of(client: ClientConnection) -> None:
    await listen(client, STATUS)
    wanted = {}
    for text in map(ours, frames(recording("ros2-rosapi.jsonl.gz"), "out")):
        operation = parsed(text)
        verb = operation["service"].removeprefix("/rosapi/")
        if verb in ("topics", "services", "action_servers") or "_action" in text:
            await client.send(text)
            wanted[verb] = (await until_answer(client, operation["id"]))["values"]
    assert wanted["topic_type"] == {"type": ""}
    assert "/robot_0/navigate_to_pose" in wanted["action_servers"]["action_servers"]
    types = dict(zip(wanted["topics"]["topics"], wanted["topics"]["types"], strict=True))
    theirs = next(
        parsed(ours(text.replace("\\/", "/")))["values"]
        for text in frames(recording("ros2-rosapi.jsonl.gz"), "in")
        if '"topics"' in text
    )
    told = dict(zip(theirs["topics"], theirs["types"], strict=True))
    for part in ("amcl_pose", "battery_state", "goal_pose", "odom", "plan"):
        assert types[f"/robot_0/{part}"] == told[f"/robot_0/{part}"]
    assert not any("_action" in name for name in (*types, *wanted["services"]["services"]))
    assert types["/map"] == told["/map"]


async def test_of_two_goals_with_one_id_the_later_is_cancelled_whatever_the_action(
    client: ClientConnection,
) -> None:
    both = [ours(text) for text in frames(recording(ACTIONS), "out") if parsed(text).get("id") == "same"]
    *goals, cancel = both
    assert [parsed(text)["action"] for text in both] == [
        "/robot_0/navigate_to_pose",
        "/robot_1/navigate_to_pose",
        "/robot_0/navigate_to_pose",
    ]
    for text in (*map(far, goals), cancel):
        await client.send(text)
    wanted = recorded(ACTIONS, "action_result", "same")
    assert await result(client, "same") == wanted
    assert (wanted["action"], wanted["status"]) == ("/robot_1/navigate_to_pose", 5)


async def test_an_action_type_is_described_as_recorded(client: ClientConnection) -> None:
    lines = recording("ros2-rosapi-types.jsonl.gz")
    (text,) = [one for one in frames(lines, "out") if "action_goal_details" in one]
    (theirs,) = [one for one in map(parsed, frames(lines, "in")) if one.get("id") == parsed(text)["id"]]
    await client.send(text)
    answer = await until_answer(client, parsed(text)["id"])
    for typedef in (*answer["values"]["typedefs"], *theirs["values"]["typedefs"]):
        del typedef["constnames"], typedef["constvalues"]  # python's own attributes, with addresses
    assert answer == theirs
