"""Operations of any client of the bridge besides watching robots, on ROS 1."""

from typing import Any

import cbor2
from rosbags.typesys import Stores, get_typestore
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import read, send

Json = dict[str, Any]
POSE, MAP = "/robot_0/pose", "/robot_0/floor_0/map"


async def test_the_bridge_names_its_clients(server: RosbridgeServer, client: ClientConnection) -> None:
    await send(client, "subscribe", topic="/connected_clients")
    (one,) = (await read(client))["msg"]["clients"]
    assert one["ip_address"] == "127.0.0.1"
    assert list(one["connection_time"]) == ["secs", "nsecs"]
    async with connect(server.url):
        assert len((await read(client))["msg"]["clients"]) == 2


async def test_cbor_raw_carries_the_map_as_ros_encodes_it(client: ClientConnection) -> None:
    await send(client, "subscribe", topic=MAP, compression="cbor-raw")
    frame = cbor2.loads(bytes(await client.recv(decode=False)))
    assert list(frame["msg"]) == ["secs", "nsecs", "bytes"]
    types = get_typestore(Stores.ROS1_NOETIC)
    grid = types.deserialize_ros1(frame["msg"]["bytes"], "nav_msgs/msg/OccupancyGrid")
    assert (grid.info.width, grid.info.height, len(grid.data)) == (800, 520, 800 * 520)  # type: ignore[attr-defined]  # made at run time


async def test_the_world_runs_faster_and_the_wire_does_not() -> None:
    server = RosbridgeServer(OhFleet(1, 1, seed=1, quiet=True), rate=20.0, speed=30.0)
    robot = server.world.robots["robot_0"]
    robot.take(19, 0, request_id=1)
    await server.start()
    async with connect(server.url) as client:
        await send(client, "subscribe", topic=POSE)
        stamps = [(await read(client))["msg"]["header"]["stamp"] for _ in range(5)]
        gone = server.world.time
        while robot.orders:  # it takes more than a minute of the robot's time
            await read(client)
    await server.stop()
    seconds = [stamp["secs"] + stamp["nsecs"] / 1e9 for stamp in stamps]
    assert seconds[-1] - seconds[0] > 0.1
    assert gone > 5 * 20 * (seconds[-1] - seconds[0]) / 5 > 0
    assert server.world.time > 60.0
