"""Goals of clients through the bridge: whose they are, what is told of them, and in which words they fail."""

import asyncio
import json
from collections.abc import Mapping
from typing import Any

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.actions import ActionDesk
from fleet_tui.simulator.frames import Frame
from fleet_tui.simulator.messages import stamped
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.errors import BridgeError
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.sessions.client import Client

TO_POSE = "/robot_0/navigate_to_pose"
TYPE = "nav2_msgs/action/NavigateToPose"


class Listener(Client):
    """Keeps what it is told."""

    def __init__(self) -> None:
        super().__init__("127.0.0.1")
        self.told: list[dict[str, Any]] = []

    def reply(self, frame: Frame) -> None:
        self.told.append(json.loads(frame))


class Desk:
    """A desk before a fleet of one robot."""

    def __init__(self) -> None:
        self.fleet = Nav2Fleet(1, 1, seed=1, quiet=True)
        self.unsourced: set[str] = set()
        self.desk = ActionDesk([self.fleet], ROS2, self.unsourced)

    def send(self, client: Client, id_: str = "a", **more: Any) -> "asyncio.Future[None]":
        goal: Mapping[str, Any] = {"pose": stamped(Pose(8.0, 0.0))}
        operation = {"id": id_, "action": TO_POSE, "action_type": TYPE, "args": goal, **more}
        return self.desk.send(client, operation)

    def live(self, seconds: float) -> None:
        self.fleet.step(seconds)
        self.desk.publish_feedback()
        self.desk.send_results()


@pytest.fixture
async def desk() -> Desk:
    return Desk()


async def test_the_result_is_told_once_to_the_one_who_gave_the_goal(desk: Desk) -> None:
    client, other = Listener(), Listener()
    ended = desk.send(client, feedback=True)
    desk.live(1.0)
    assert [one["op"] for one in client.told] == ["action_feedback"] and not ended.done()
    desk.live(60.0)
    desk.live(1.0)
    assert [one["op"] for one in client.told] == ["action_feedback", "action_result"] and ended.done()
    assert (client.told[-1]["id"], client.told[-1]["status"], client.told[-1]["result"]) == ("a", 4, True)
    assert other.told == []


async def test_who_is_gone_is_told_nothing_and_the_goal_goes_on(desk: Desk) -> None:
    client = Listener()
    desk.send(client)
    desk.desk.gone(client)
    desk.live(60.0)
    assert client.told == [] and desk.fleet.robots["robot_0"].pose.x == pytest.approx(8.0)


async def test_a_client_cancels_its_own_goals_alone(desk: Desk) -> None:
    client, other = Listener(), Listener()
    desk.send(client)
    with pytest.raises(BridgeError, match="No goal with id a to cancel"):
        desk.desk.cancel(other, {"id": "a"})
    desk.desk.cancel(client, {"id": "a"})
    desk.live(2.0)
    assert client.told[-1]["status"] == 5


async def test_goals_that_come_to_nothing_fail_with_their_reason(desk: Desk) -> None:
    client = Listener()
    for more in (
        {"action_type": "no_msgs/action/No"},
        {"action_type": "nav2_msgs/action/No"},
        {"args": {"x": 1}},
    ):
        assert desk.send(client, **more).done()
    await desk.send(client, action="/robot_9/navigate_to_pose")
    unknown, missing, field, server = [one["values"] for one in client.told]
    assert "no_msgs" in unknown and "has no attribute 'No'" in missing and "does not have a field x" in field
    assert server == "No action server available"
    assert {(one["status"], one["result"]) for one in client.told} == {(0, False)}


async def test_a_bridge_that_lacks_the_package_or_tells_no_failure(desk: Desk) -> None:
    client = Listener()
    assert desk.desk.names and TO_POSE in desk.desk.names
    desk.fleet.actions[TO_POSE].die()
    assert TO_POSE not in desk.desk.names
    desk.desk.reports_failure = False
    assert not desk.send(client).done() and client.told == []
    desk.unsourced.add("nav2_msgs")
    assert desk.send(client).done() and "nav2_msgs" in client.told[0]["values"]
