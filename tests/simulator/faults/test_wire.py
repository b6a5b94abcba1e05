"""Faults of the wire, while the robot itself does what it should."""

import asyncio
import json
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.faults import parse_faults, wire
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.polling import HANGS

ORDER = "/robot_0/Application_layout/Execute_order"


@asynccontextmanager
async def served(name: str) -> AsyncIterator[tuple[RosbridgeServer, ClientConnection]]:
    server = RosbridgeServer(OhFleet(1, 1, seed=1, quiet=True))
    play(server, parse_faults(name, server.world.robots))
    await server.start()
    async with connect(server.url) as client:
        args = {"request_id": 1, "initial_point": 19, "end_point": 0}
        call = {"op": "call_service", "id": "call:1", "service": ORDER, "args": args}
        await client.send(json.dumps(call))
        await client.send(json.dumps({"op": "call_service", "id": "after", "service": "/rosapi/get_time"}))
        yield server, client
    await server.stop()


async def answers(client: ClientConnection) -> list[dict[str, Any]]:
    """The messages on the order that arrived before the call behind it was answered."""
    found = []
    while (answer := json.loads(await client.recv()))["id"] != "after":
        found.append(answer)
    return found


FAILURES = {
    "dies": "transport error completing service call: unable to receive data from sender,"
    " check sender's logs for details",
    "throws": f"service [{ORDER}] responded with an error: b'error processing request: no route'",
    "unsourced": "Unable to load the manifest for package OH_ressources. Caused by: OH_ressources",
}


@pytest.mark.parametrize(
    ("name", "ids", "carried_out"),
    [
        ("refuse", ["call:1"], 0),
        ("late", [], 1),
        ("twice", ["call:1", "call:1"], 1),
        ("never", [], 0),
        ("wrong-id", ["not-call:1"], 1),
        ("late-call", [], 0),
        ("obeys-late", ["call:1"], 0),
        ("dies", ["call:1"], 1),
        ("throws", ["call:1"], 0),
        ("unsourced", ["call:1"], 0),
    ],
)
async def test_faults_of_the_answer(name: str, ids: list[str], carried_out: int) -> None:
    async with served(name) as (server, client):
        came = await answers(client)
        assert [answer["id"] for answer in came] == ids
        assert len(server.world.robots["robot_0"].orders) == carried_out
        if ids:
            assert came[0]["result"] is (name not in FAILURES)
            assert str(came[0]["values"]) == FAILURES.get(name, str(came[0]["values"]))
        if name == "refuse":
            assert came[0]["values"]["status"].startswith("REJECTED")


async def test_a_late_answer_comes_in_the_end() -> None:
    async with served("late") as (_, client):
        assert await answers(client) == []
        async with asyncio.timeout(HANGS):
            assert json.loads(await client.recv())["id"] == "call:1"


async def test_a_frozen_node_takes_the_order_when_it_wakes() -> None:
    async with served("late-call") as (server, client):
        assert await answers(client) == []
        assert server.world.robots["robot_0"].orders == []
        async with asyncio.timeout(HANGS):
            assert json.loads(await client.recv())["id"] == "call:1"
        assert len(server.world.robots["robot_0"].orders) == 1


async def test_a_command_is_obeyed_long_after_its_answer() -> None:
    async with served("obeys-late") as (server, client):
        robot = server.world.robots["robot_0"]
        (answer,) = await answers(client)
        assert answer["values"] == {"request_id": 1, "status": "executed"}
        async with asyncio.timeout(HANGS):
            await client.send(json.dumps({"op": "subscribe", "topic": "/robot_0/queue"}))
            while not json.loads(await client.recv())["msg"]["orders"]:
                pass
        pause = {"op": "call_service", "id": "p", "service": "/robot_0/Application_layout/Pause"}
        await client.send(json.dumps(pause))
        while (answer := json.loads(await client.recv())).get("id") != "p":
            pass
        assert answer["values"] == {"success": True, "message": "executed"}
        assert not robot.paused
        async with asyncio.timeout(HANGS):
            while not robot.paused:
                await client.recv()


async def test_services_that_are_no_longer_registered() -> None:
    async with served("unregistered") as (server, client):
        await client.send(json.dumps({"op": "subscribe", "topic": "/robot_0/pose"}))
        async with asyncio.timeout(HANGS):
            while server.bridge.services.offered:
                await client.recv()
        await client.send(json.dumps({"op": "call_service", "id": "again", "service": ORDER}))
        seen = [json.loads(await client.recv()) for _ in range(5)]
        (answer,) = (frame for frame in seen if frame.get("id") == "again")
        assert (answer["values"], answer["result"]) == (f"Service {ORDER} does not exist", False)
        assert any(frame["op"] == "publish" for frame in seen)


async def test_a_frozen_rosapi_leaves_the_bridge_alive() -> None:
    heartbeat = "/rosapi/fleet_tui_heartbeat"
    async with served("frozen-rosapi") as (_, client):
        await client.send(json.dumps({"op": "call_service", "id": "h", "service": heartbeat}))
        came = [json.loads(await client.recv()) for _ in range(2)]
    assert [frame["id"] for frame in came] == ["call:1", "h"]  # and none for /rosapi/get_time
    assert (came[1]["values"], came[1]["result"]) == (f"Service {heartbeat} does not exist", False)


async def test_a_dead_rosapi_is_not_there() -> None:
    async with served("dead-rosapi") as (_, client):
        came = [json.loads(await client.recv()) for _ in range(2)]
    assert [frame["result"] for frame in came] == [True, False]
    assert came[1]["values"] == "Service /rosapi/get_time does not exist"


async def test_messages_beyond_the_bridge_never_come_though_rosapi_names_them() -> None:
    async with served("unsourced") as (_, client):
        await answers(client)
        for topic in ("queue", "floor_0/graph", "floor_0/map_metadata", "battery"):
            await client.send(json.dumps({"op": "subscribe", "topic": f"/robot_0/{topic}"}))
        came = {json.loads(await client.recv())["topic"] for _ in range(4)}
        assert came == {"/robot_0/floor_0/map_metadata", "/robot_0/battery"}
        args = {"topic": "/robot_0/queue"}
        call = {"op": "call_service", "id": "t", "service": "/rosapi/topic_type", "args": args}
        await client.send(json.dumps(call))
        while (answer := json.loads(await client.recv())).get("id") != "t":
            pass
        assert answer["values"] == {"type": "OH_ressources/ActionQueue"}


async def test_an_overloaded_bridge_falls_behind_with_everything(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wire, "CARRIED", 5.0)
    async with served("overloaded") as (_, client):
        await answers(client)
        await client.send(json.dumps({"op": "subscribe", "topic": "/robot_0/pose"}))
        ages = []
        for _ in range(6):
            stamp = json.loads(await client.recv())["msg"]["header"]["stamp"]
            ages.append(time.time() - stamp["secs"] - stamp["nsecs"] / 1e9)
        assert ages == pytest.approx(sorted(ages), abs=0.1), "but for the clock of this machine"
        assert ages[-1] - ages[0] > 0.3
        begun = time.monotonic()
        await client.send(json.dumps({"op": "call_service", "id": "after", "service": "/rosapi/get_time"}))
        while json.loads(await client.recv()).get("id") != "after":
            pass
        assert time.monotonic() - begun > 0.3


async def test_a_dropped_connection_was_no_dropped_order() -> None:
    async with served("drop") as (server, client):
        with pytest.raises(ConnectionClosed):
            await answers(client)
        assert len(server.world.robots["robot_0"].orders) == 1


async def test_a_stale_pose_stays_away_and_the_rest_comes() -> None:
    server = RosbridgeServer(OhFleet(1, 1, seed=1, quiet=True))
    play(server, parse_faults("stale", server.world.robots))
    await server.start()
    async with connect(server.url) as client:
        for topic in ("pose", "battery"):
            await client.send(json.dumps({"op": "subscribe", "topic": f"/robot_0/{topic}"}))
        came = {json.loads(await client.recv())["topic"] for _ in range(4)}
    await server.stop()
    assert came == {"/robot_0/battery"}
