"""Topics of robots with move_base."""

import json

from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.move_base_client import RESULT, STATUS, give, listed, pose, result
from tests.support.nav2_client import Json, listen, settle

FAR, NEAR = pose(35.0, 20.0), pose(8.0, 0.0)


async def test_the_status_is_a_heartbeat_even_without_goals(client: ClientConnection) -> None:
    await listen(client, STATUS)
    frames = list[Json]()
    while len(frames) < 6:
        frames.append(json.loads(await client.recv()))
    assert {len(frame["msg"]["status_list"]) for frame in frames} == {0}
    counted = [frame["msg"]["header"]["seq"] for frame in frames]
    assert counted == list(range(counted[0], counted[0] + 6))
    first, last = (frame["msg"]["header"]["stamp"] for frame in (frames[0], frames[-1]))
    assert 0.9 < last["secs"] - first["secs"] + (last["nsecs"] - first["nsecs"]) * 1e-9 < 30.0


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


async def test_several_floors_have_a_map_each_and_robots_tell_theirs() -> None:
    server = RosbridgeServer(MoveBaseFleet(2, 2, seed=1, quiet=True))
    types = server.bridge.services.types
    assert types["/floor_1/map"] == "nav_msgs/OccupancyGrid" and "/map" not in types
    assert types["/floor_1/map_metadata"] == "nav_msgs/MapMetaData"
    info = json.loads(server.bridge.topics["/floor_1/map_metadata"].payload(0.0).json)
    assert info == json.loads(server.bridge.topics["/floor_1/map"].payload(0.0).json)["info"]
    assert json.loads(server.bridge.topics["/robot_1/floor"].payload(0.0).json) == {"data": "floor_1"}
