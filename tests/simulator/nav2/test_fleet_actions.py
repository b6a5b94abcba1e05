"""Goals through the bridge: whose they are, and what is told of them."""

import asyncio
import json

from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.goals import EXECUTING
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_client import TO_POSE, give, pose, result, settle
from tests.support.polling import HANGS


async def test_a_replaced_goal_ends_aborted_before_the_new_one(client: ClientConnection) -> None:
    await give(client, "a", TO_POSE, pose=pose(35.0, 20.0))
    await give(client, "b", TO_POSE, pose=pose(8.0, 0.0))
    first, second = await result(client, "a"), await result(client, "b")
    assert (first["status"], first["result"], second["status"]) == (6, True, 4)


async def test_the_senders_connection_alone_cancels_by_its_own_id(
    server: RosbridgeServer, client: ClientConnection, fleet: Nav2Fleet
) -> None:
    async with connect(server.url, close_timeout=0.1) as sender:
        await give(sender, "a", TO_POSE, pose=pose(35.0, 20.0))
        await settle(sender)
        await client.send(json.dumps({"op": "cancel_action_goal", "id": "a", "action": TO_POSE}))
        await settle(client)
        (goal,) = fleet.actions[TO_POSE].running
    assert goal.status == EXECUTING
    async with asyncio.timeout(HANGS):
        while not goal.over:  # noqa: ASYNC110  # its sender is gone, it goes on
            await asyncio.sleep(0.1)
    assert goal.status == 4


async def test_a_bridge_of_ros_1_knows_no_goals() -> None:
    server = RosbridgeServer(OhFleet(1, 1, seed=1, quiet=True))
    await server.start()
    async with connect(server.url, close_timeout=0.1) as client:
        await give(client, "a", TO_POSE, pose=pose(8.0, 0.0))
        await client.send('{"op":"call_service","id":"x","service":"/no/such"}')
        assert json.loads(await client.recv())["id"] == "x"
    await server.stop()
