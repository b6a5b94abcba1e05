"""Frames of the robots' poses: of those that are online, and of no topic with a wrong type."""

import asyncio
import time

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.frames import collect_frames
from fleet_tui.links.discovery.recognition import Found
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.robots.discovery import Discovery
from fleet_tui.simulator.server import RosbridgeServer

POSE = "geometry_msgs/PoseStamped"
FOUND = {"oh_ressources": Discovery({f"robot_{n}": [] for n in range(3)})}


async def received(server: RosbridgeServer, types: dict[str, str], found: Found = FOUND) -> dict[str, str]:
    async def hear() -> dict[str, str]:
        wire = BridgeConnection(Link(server.url))
        try:
            assert not await wire.connect(5.0)
            return await collect_frames(wire, found, types, time.monotonic() + 5)
        finally:
            wire.close()

    return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(hear(), network_loop()))


async def test_each_robot_that_is_online_has_the_frame_of_its_poses(server: RosbridgeServer) -> None:
    types = {f"/robot_{n}/pose": POSE for n in range(2)}
    assert await received(server, types) == {"robot_0": "floor_0", "robot_1": "floor_1"}


async def test_a_silent_robot_has_none_and_one_of_another_type_is_not_listened_to(
    server: RosbridgeServer,
) -> None:
    server.bridge.muted.add("/robot_0/pose")
    types = {"/robot_0/pose": POSE, "/robot_1/pose": "std_msgs/String"}
    assert await received(server, types) == {}
    assert {one["topic"] for one in server.bridge.received if one["op"] == "subscribe"} == {"/robot_0/pose"}
