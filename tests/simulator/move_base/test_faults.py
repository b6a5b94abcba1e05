"""Each fault of robots with move_base, as a client meets it."""

import asyncio
import json

import pytest
from websockets.asyncio.client import ClientConnection
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.move_base.faults import FAULTS
from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.move_base.navigation import NO_CONTROL, NO_PLAN, REACHED
from fleet_tui.simulator.navigating.faults import EVERY
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.move_base_client import (
    CANCEL,
    FEEDBACK,
    GOAL,
    RESULT,
    STATUS,
    TYPES,
    cancel,
    give,
    listed,
    pose,
    result,
    told,
)
from tests.support.nav2_client import call, latest, listen, settle, until

FAR, NEAR = pose(35.0, 20.0), pose(8.0, 0.0)


def plant(server: RosbridgeServer, name: str) -> None:
    play(server, parse_faults(f"{name}:robot_0", server.bridge.services.robots, FAULTS))


@pytest.mark.parametrize(
    ("name", "end"),
    [
        ("reject", (5, "")),
        ("no-plan", (4, NO_PLAN)),
        ("stuck", (4, NO_CONTROL)),
        ("obstacle", (4, NO_CONTROL)),
        ("no-feedback", (3, REACHED)),
    ],
)
async def test_goals_end_as_they_must(
    server: RosbridgeServer, client: ClientConnection, name: str, end: tuple[int, str]
) -> None:
    plant(server, name)
    await listen(client, RESULT)
    await listen(client, FEEDBACK)
    await give(client, "a", NEAR)
    feedback = 0
    while (frame := json.loads(await client.recv()))["topic"] == FEEDBACK:
        feedback += 1
    status = frame["msg"]["status"]
    assert (status["status"], status["text"]) == end
    assert (feedback > 0) is (name not in ("reject", "no-feedback"))


@pytest.mark.parametrize(("name", "end"), [("aborts", (4, NO_CONTROL)), ("foreign-cancel", (2, ""))])
async def test_a_drive_is_ended(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet, name: str, end: tuple[int, str]
) -> None:
    server.speed = 1.0
    plant(server, name)
    await listen(client, RESULT)
    await give(client, "a", FAR)
    await settle(client)
    fleet.step(4.0)
    assert await result(client, "a") == end


def test_another_client_gives_goals(server: RosbridgeServer, fleet: MoveBaseFleet) -> None:
    server.speed = 1.0
    plant(server, "foreign-goal")
    fleet.step(EVERY - 1.0)
    assert not fleet.navigation["robot_0"].received
    fleet.step(2.0)
    assert len(fleet.navigation["robot_0"].received) == 1 and not fleet.navigation["robot_1"].received


async def test_a_node_that_restarts_lists_nothing_and_tells_no_result(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet
) -> None:
    server.speed = 1.0
    plant(server, "restart")
    for topic in (STATUS, RESULT):
        await listen(client, topic)
    await give(client, "a", FAR)
    await told(client, {"a": 1})
    fleet.step(4.0)
    topics = set()
    while (frame := json.loads(await client.recv()))["topic"] == RESULT or listed(frame):
        topics.add(frame["topic"])
    assert topics <= {STATUS} and not fleet.robots["robot_0"].driving
    await give(client, "b", FAR)
    fleet.step(4.0)
    await told(client, {"b": 1})  # it restarts once


async def test_a_dead_node_says_and_takes_nothing_more(
    server: RosbridgeServer, client: ClientConnection, other: ClientConnection, fleet: MoveBaseFleet
) -> None:
    server.speed = 1.0
    plant(server, "dead-server")
    await give(client, "a", FAR)
    await settle(client)
    fleet.step(4.0)
    await settle(client)
    assert not fleet.robots["robot_0"].driving
    await listen(other, STATUS)
    await listen(other, "/robot_1/move_base/status")
    await give(client, "b", FAR)
    for _ in range(5):
        assert json.loads(await other.recv())["topic"] == "/robot_1/move_base/status"
    assert len(fleet.navigation["robot_0"].received) == 1


@pytest.mark.parametrize("name", ["never", "refuse-cancel"])
async def test_what_is_not_heard_has_no_effect(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet, name: str
) -> None:
    plant(server, name)
    await give(client, "a", FAR)
    await cancel(client, "a")
    await settle(client)
    assert bool(fleet.navigation["robot_0"].received) is (name == "refuse-cancel")
    assert fleet.navigation["robot_0"].busy is (name == "refuse-cancel")


async def test_what_is_heard_late_is_done_late(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "late")
    await listen(client, STATUS)
    began = asyncio.get_running_loop().time()
    await give(client, "a", FAR)
    await told(client, {"a": 1})
    assert asyncio.get_running_loop().time() - began > 0.3


async def test_connections_break_after_a_goal_was_taken(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet
) -> None:
    plant(server, "drop")
    await give(client, "a", FAR)
    with pytest.raises(ConnectionClosed):
        await client.recv()
    assert fleet.navigation["robot_0"].busy


class TestFirstLost:
    async def test_what_is_published_at_once_is_lost(
        self, server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet
    ) -> None:
        plant(server, "first-lost")
        await give(client, "a", FAR)
        await settle(client)
        assert not fleet.navigation["robot_0"].received

    async def test_what_is_advertised_before_is_heard(
        self, server: RosbridgeServer, client: ClientConnection, other: ClientConnection, fleet: MoveBaseFleet
    ) -> None:
        plant(server, "first-lost")
        for topic in (GOAL, CANCEL):
            await client.send(json.dumps({"op": "advertise", "topic": topic, "type": TYPES[topic]}))
        await settle(client)
        server.bridge.services.guests.connects_in = 0.0  # as after that time
        await give(client, "a", FAR)
        await settle(client)
        assert fleet.navigation["robot_0"].busy
        server.bridge.services.guests.connects_in = 1000.0
        await cancel(other, "a")  # its own connection has not advertised
        await client.send(json.dumps({"op": "unadvertise", "topic": CANCEL}))
        await cancel(client, "a")
        await settle(client)
        await settle(other)
        assert [one.status for one in fleet.navigation["robot_0"].server.running] in ([0], [1])


async def test_a_bridge_without_the_package_takes_no_goal(
    server: RosbridgeServer, client: ClientConnection, fleet: MoveBaseFleet
) -> None:
    plant(server, "unsourced")
    await listen(client, FEEDBACK)
    await give(client, "a", FAR)
    await listen(client, STATUS)
    assert listed(await until(client, lambda frame: "topic" in frame)) == {}
    assert not fleet.navigation["robot_0"].received


@pytest.mark.parametrize(
    ("name", "topic"),
    [("no-odom", "odom"), ("silent", "odom"), ("unlocalised", "amcl_pose"), ("silent", "move_base/status")],
)
async def test_what_is_missing_never_comes(
    server: RosbridgeServer, client: ClientConnection, name: str, topic: str
) -> None:
    plant(server, name)
    await listen(client, f"/robot_0/{topic}")
    await listen(client, "/robot_1/odom")
    for _ in range(20):
        assert json.loads(await client.recv())["topic"] == "/robot_1/odom"


async def test_who_is_lost_says_how_unsure_it_is(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "lost")
    covariance = (await latest(client, "/robot_0/amcl_pose"))["pose"]["covariance"]
    assert covariance[0] + covariance[7] > 0.5


async def test_rosapi_freezes_and_dies(server: RosbridgeServer, client: ClientConnection) -> None:
    plant(server, "dead-rosapi")
    assert "does not exist" in await call(client, "/rosapi/topics")
