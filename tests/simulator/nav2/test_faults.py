"""Each fault of robots with Nav2, as a client meets it."""

import asyncio
import json

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.navigating.faults import EVERY
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import ConfigError
from tests.support.nav2_client import (
    TO_POSE,
    call,
    give,
    latest,
    listen,
    pose,
    result,
    settle,
    statuses,
    until,
)

FAR, NEAR = pose(35.0, 20.0), pose(8.0, 0.0)
STATUS, FEEDBACK = f"{TO_POSE}/_action/status", f"{TO_POSE}/_action/feedback"
ACTIVE = "/robot_0/lifecycle_manager_navigation/is_active"
QUICK = 100.0  # the seconds of faults are those of the wall; with this speed there are more of them


def plant(server: RosbridgeServer, name: str) -> None:
    play(server, parse_faults(f"{name}:robot_0", server.bridge.services.robots, FAULTS))


def test_a_fault_of_another_kind_is_named() -> None:
    with pytest.raises(ConfigError, match="restart: unknown fault of this kind of robots"):
        parse_faults("restart", ["robot_0"], FAULTS)


@pytest.mark.parametrize(("name", "active"), [("inactive", False), ("reject", True)])
async def test_goals_are_rejected(
    server: RosbridgeServer, client: ClientConnection, name: str, active: bool
) -> None:
    plant(server, name)
    await give(client, "a", TO_POSE, pose=NEAR)
    answer = await result(client, "a")
    assert (answer["values"], answer["status"], answer["result"]) == ("Action goal was rejected", 0, False)
    assert (await call(client, ACTIVE))["success"] is active


async def test_an_old_bridge_never_answers_a_rejection(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    plant(server, "reject")
    plant(server, "mute-rejection")
    await give(client, "a", TO_POSE, pose=NEAR)
    await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
    assert json.loads(await client.recv())["id"] == "x"


@pytest.mark.parametrize(("name", "status", "code"), [("aborts", 6, 105), ("foreign-cancel", 5, 0)])
async def test_a_drive_is_ended(
    server: RosbridgeServer, client: ClientConnection, name: str, status: int, code: int
) -> None:
    server.speed = 1.0
    plant(server, name)
    await give(client, "a", TO_POSE, pose=FAR)
    await settle(client)
    server.fleets[0].step(4.0)
    answer = await result(client, "a")
    assert (answer["status"], answer["values"]["error_code"]) == (status, code)


@pytest.mark.parametrize("name", ["stuck", "obstacle"])
async def test_who_stands_gives_up(server: RosbridgeServer, client: ClientConnection, name: str) -> None:
    plant(server, name)
    server.speed = QUICK
    await listen(client, FEEDBACK)
    await settle(client)
    await give(client, "a", TO_POSE, pose=FAR)
    told = await until(client, lambda frame: frame["msg"]["feedback"]["number_of_recoveries"] == 2)
    assert told["msg"]["feedback"]["estimated_time_remaining"] == {"sec": 0, "nanosec": 0}
    answer = await result(client, "a")
    assert (answer["status"], answer["values"]["error_code"]) == (6, 105)


def test_another_client_gives_goals(server: RosbridgeServer, fleet: Nav2Fleet) -> None:
    server.speed = 1.0
    plant(server, "foreign-goal")
    fleet.step(EVERY - 1.0)
    assert not fleet.navigation["robot_0"].received
    fleet.step(2.0)
    assert len(fleet.navigation["robot_0"].received) == 1 and not fleet.navigation["robot_1"].received


async def test_no_goal_is_let_go(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "refuse-cancel")
    await give(client, "a", TO_POSE, pose=FAR)
    assert (await call(client, f"{TO_POSE}/_action/cancel_goal"))["return_code"] == 1


async def test_a_dead_server_says_nothing_more(
    server: RosbridgeServer, client: ClientConnection, other: ClientConnection, fleet: Nav2Fleet
) -> None:
    server.speed = 1.0
    plant(server, "dead-server")
    await give(client, "a", TO_POSE, pose=FAR)
    await settle(client)
    fleet.step(4.0)
    assert TO_POSE not in (await call(other, "/rosapi/action_servers"))["action_servers"]
    await listen(other, STATUS)
    await give(other, "b", TO_POSE, pose=NEAR)
    answer = json.loads(await other.recv())
    assert answer["values"] == "No action server available"
    assert not fleet.robots["robot_0"].driving
    await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
    assert json.loads(await client.recv())["id"] == "x"


@pytest.mark.parametrize(
    ("name", "topic"), [("no-feedback", FEEDBACK), ("no-odom", "/robot_0/odom"), ("silent", "/robot_0/odom")]
)
async def test_what_is_missing_never_comes(
    server: RosbridgeServer, client: ClientConnection, name: str, topic: str
) -> None:
    plant(server, name)
    await listen(client, topic)
    await listen(client, "/robot_1/odom")
    await give(client, "a", TO_POSE, pose=FAR)
    for _ in range(20):
        assert json.loads(await client.recv())["topic"] == "/robot_1/odom"


async def test_who_is_silent_has_no_latched_values(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "silent")
    await give(client, "a", TO_POSE, pose=NEAR)
    for topic in ("/robot_0/amcl_pose", STATUS):
        await listen(client, topic)
    await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
    assert json.loads(await client.recv())["id"] == "x"


async def test_who_is_heard_again_tells_how_its_goals_stand(
    client: ClientConnection, fleet: Nav2Fleet
) -> None:
    await listen(client, STATUS)
    await settle(client)
    fleet.robots["robot_0"].silence = 30.0
    fleet.navigation["robot_0"].give(-99.0, 0.0)
    assert statuses(json.loads(await client.recv())) == [6]
    assert not fleet.robots["robot_0"].silence


async def test_who_is_lost_says_how_unsure_it_is(server: RosbridgeServer, client: ClientConnection) -> None:
    sure = await latest(client, "/robot_0/amcl_pose")
    assert sure["pose"]["covariance"][0] + sure["pose"]["covariance"][7] < 0.5
    plant(server, "lost")
    lost = await until(client, lambda frame: "msg" in frame)
    covariance, position = lost["msg"]["pose"]["covariance"], lost["msg"]["pose"]["pose"]["position"]
    assert covariance[0] + covariance[7] > 0.5
    assert position["x"] == pytest.approx(sure["pose"]["pose"]["position"]["x"] + 2.0)


async def test_a_bridge_without_the_package_knows_no_action(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    plant(server, "unsourced")
    await give(client, "a", TO_POSE, pose=NEAR)
    assert "No module named 'nav2_msgs'" in (await result(client, "a"))["values"]


class TestHumble:
    async def test_a_goal_blocks_its_connection_cancel_included(
        self, server: RosbridgeServer, client: ClientConnection, other: ClientConnection
    ) -> None:
        plant(server, "humble")
        await listen(client, "/robot_0/odom")
        await give(client, "a", TO_POSE, pose=NEAR)
        await client.send(json.dumps({"op": "cancel_action_goal", "id": "a", "action": TO_POSE}))
        await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
        odometry = []
        while (frame := json.loads(await client.recv()))["op"] == "publish":
            odometry.append(frame)
        assert odometry and (frame["status"], frame["values"]) == (4, {})
        assert (await until(client, lambda frame: frame["op"] != "publish"))["id"] == "x"
        version = await call(other, "/rosapi/get_ros_version")
        assert version == {"version": 2, "distro": "humble"}

    async def test_who_is_gone_waits_for_nothing(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        plant(server, "humble")
        plant(server, "mute-rejection")
        plant(server, "reject")
        await give(client, "a", TO_POSE, pose=NEAR)
        await client.close()
        await server.stop()

    async def test_a_call_without_limit_is_waited_for(
        self, server: RosbridgeServer, client: ClientConnection, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        plant(server, "humble")
        server.bridge.services.silent_services.add(ACTIVE)
        ask = {"op": "call_service", "id": "limited", "service": ACTIVE, "timeout": 0.05}
        await client.send(json.dumps(ask))
        assert "Timeout" in json.loads(await client.recv())["values"]
        del ask["timeout"]
        await client.send(json.dumps(ask))
        await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(client.recv(), 0.3)


@pytest.mark.parametrize(
    ("name", "topic", "prefix"), [("tf-only", "/tf", "robot_0/"), ("own-tf", "/robot_0/tf", "")]
)
async def test_transforms_have_two_publishers_of_which_a_throttle_drops_one(
    server: RosbridgeServer, client: ClientConnection, name: str, topic: str, prefix: str
) -> None:
    plant(server, name)
    listed = await call(client, "/rosapi/topics")
    assert topic in listed["topics"] and "/robot_0/amcl_pose" not in listed["topics"]
    frames = await heard(client, topic, 0)
    assert set(frames) == {f"{prefix}odom", f"{prefix}base_footprint"}
    assert frames.count(f"{prefix}base_footprint") == pytest.approx(
        2.5 * frames.count(f"{prefix}odom"), abs=4
    )
    await client.send(json.dumps({"op": "unsubscribe", "topic": topic}))
    assert len(set(await heard(client, topic, 1000, 3))) == 1


async def heard(client: ClientConnection, topic: str, throttle_rate: int, most: int = 70) -> list[str]:
    """The child frames of so many messages of transforms."""
    await client.send(json.dumps({"op": "subscribe", "topic": topic, "throttle_rate": throttle_rate}))
    frames = [await until(client, lambda frame: frame.get("topic") == topic) for _ in range(most)]
    return [one["msg"]["transforms"][0]["child_frame_id"] for one in frames]


@pytest.mark.parametrize("name", ["dead-localisation", "tf-only,dead-localisation"])
async def test_a_dead_localisation_says_nothing_while_the_wheels_count_on(
    server: RosbridgeServer, client: ClientConnection, name: str
) -> None:
    server.speed = 1.0
    play(server, parse_faults(name, ["robot_0"], FAULTS))
    fleet = server.fleets[0]
    assert isinstance(fleet, Nav2Fleet)
    await give(client, "a", TO_POSE, pose=FAR)
    await settle(client)
    fleet.step(10.0)
    robot = fleet.robots["robot_0"]
    assert robot.is_unlocalised
    listed = await call(client, "/rosapi/topics")
    assert "/robot_0/amcl_pose" not in listed["topics"]
    before, estimate = robot.odom, robot.estimate
    fleet.step(5.0)
    assert robot.odom != before and robot.estimate == estimate
