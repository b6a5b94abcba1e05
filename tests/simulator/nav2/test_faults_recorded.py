"""Faults of robots with Nav2 against recordings of a real one: the same frames."""

import json
from collections.abc import Iterator

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_client import TO_POSE, Json, give, listen, pose, settle, statuses, until
from tests.support.transcripts import frames, parsed, recording, shape, until_answer

FAR = pose(35.0, 20.0)
STATUS = f"{TO_POSE}/_action/status"


def plant(server: RosbridgeServer, faults: str) -> None:
    play(server, parse_faults(faults, ["robot_0"], FAULTS))


def ours(text: str) -> str:
    """A frame of the recorded robot, which has no namespace, with ours."""
    plain = text.replace("\\/", "/")
    for key in ("service", "action", "topic"):
        plain = plain.replace(f'"{key}":"/', f'"{key}":"/robot_0/')
        plain = plain.replace(f'"{key}": "/', f'"{key}": "/robot_0/')
    return plain


def recorded(name: str, direction: str = "in") -> Iterator[Json]:
    for text in frames(recording(f"nav2-{name}.jsonl.gz"), direction):
        if frame := parsed(ours(text)):
            yield frame


def first(name: str, topic: str) -> Json:
    return next(frame for frame in recorded(name) if frame.get("topic") == topic)


def lines(name: str, text: str) -> tuple[int, str]:
    """The level and the node of the recorded log line with a text."""
    found = next(frame["msg"] for frame in recorded(name) if text in frame.get("msg", {}).get("msg", ""))
    return found["level"], found["name"]


async def test_nav2_that_is_inactive_answers_as_recorded(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    plant(server, "inactive")
    theirs = {frame["id"]: frame for frame in recorded("goal-while-inactive")}
    for frame in recorded("goal-while-inactive", "out"):
        await client.send(json.dumps(frame))
        assert await until_answer(client, frame["id"]) == theirs[frame["id"]]


async def test_transforms_are_sent_as_recorded(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "tf-only")
    theirs = first("tf-only-goto", "/robot_0/tf")
    await listen(client, "/tf")
    told = [await until(client, lambda frame: frame.get("topic") == "/tf") for _ in range(20)]
    assert shape(told[0]) == shape(theirs)
    ways = {
        (one["header"]["frame_id"].removeprefix("robot_0/"), one["child_frame_id"].removeprefix("robot_0/"))
        for frame in told
        for one in frame["msg"]["transforms"]
    }
    assert ways == {(one["header"]["frame_id"], one["child_frame_id"]) for one in theirs["msg"]["transforms"]}


async def test_a_volatile_pose_is_sent_as_recorded(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "volatile-pose")
    await listen(client, "/robot_0/amcl_pose")
    told = await until(client, lambda frame: frame.get("topic") == "/robot_0/amcl_pose")
    assert shape(told["msg"]) == shape(first("slam-pose-volatile", "/robot_0/pose")["msg"])


async def test_a_spin_of_another_client_is_driven_and_told_as_recorded(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    (goal,) = [one for one in recorded("spin-direct-pause", "out") if one["op"] == "send_action_goal"]
    (theirs,) = [one for one in recorded("spin-direct-pause") if one["op"] == "action_result"]
    await listen(client, "/robot_0/odom")
    await client.send(json.dumps(goal))
    turning = await until(
        client, lambda frame: frame.get("topic") and frame["msg"]["twist"]["twist"]["angular"]["z"]
    )
    assert shape(turning) == shape(first("spin-direct-pause", "/robot_0/odom"))
    told = await until(client, lambda frame: frame["op"] == "action_result")
    assert shape(told) == shape(theirs) and (told["status"], told["id"]) == (theirs["status"], theirs["id"])


@pytest.mark.parametrize(
    ("fault", "name", "text"),
    [
        ("silent-aborts", "cancel-midway", "Timed out while waiting for action server to acknowledge"),
        ("node-down", "kill-controller2", "CRITICAL FAILURE: SERVER controller_server IS DOWN"),
    ],
)
async def test_what_nav2_logs_is_logged_as_recorded(
    server: RosbridgeServer, client: ClientConnection, fleet: Nav2Fleet, fault: str, name: str, text: str
) -> None:
    server.speed = 1.0
    await listen(client, "/rosout")
    await listen(client, STATUS)
    await settle(client)
    plant(server, fault)
    if fault == "silent-aborts":
        await give(client, "a", TO_POSE, pose=FAR)
        await settle(client)
        fleet.step(10.0)
    told = await until(client, lambda frame: text in frame.get("msg", {}).get("msg", ""))
    assert told["msg"]["name"] == f"robot_0.{lines(name, text)[1]}"
    assert told["msg"]["level"] == lines(name, text)[0]
    assert shape(told["msg"]) == shape(
        next(frame for frame in recorded(name) if "level" in frame["msg"])["msg"]
    )


async def test_a_silent_abort_ends_a_goal_as_recorded(
    server: RosbridgeServer, client: ClientConnection, fleet: Nav2Fleet
) -> None:
    server.speed = 1.0
    plant(server, "silent-aborts")
    await listen(client, STATUS)
    await give(client, "a", TO_POSE, pose=FAR)
    await settle(client)
    fleet.step(10.0)
    told = await until(client, lambda frame: frame.get("topic") == STATUS and statuses(frame)[-1] == 6)
    theirs = [one for one in recorded("cancel-midway") if one.get("topic") == STATUS]
    assert shape(told) == shape(theirs[-1]) and statuses(theirs[-1])[-1] == 6
    result = await until(client, lambda frame: frame["op"] == "action_result")
    assert (result["values"]["error_code"], result["values"]["error_msg"]) == (0, "")


async def test_a_manager_that_waits_for_a_node_leaves_a_call_unanswered_as_recorded(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    plant(server, "bring-up")
    assert not [one for one in recorded("diagnostics-inactive") if one["op"] == "service_response"]
    (asked,) = [one for one in recorded("diagnostics-inactive", "out") if one["op"] == "call_service"]
    await client.send(json.dumps(asked))
    await client.send(json.dumps(asked | {"id": "after", "service": "/rosapi/get_time"}))
    assert json.loads(await client.recv())["id"] == "after"
