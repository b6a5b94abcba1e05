"""The topic of a drive, as rosapi knows it: without a listener of the right type no drive begins."""

from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.driving import R0, driving


async def test_nobody_listens(server: RosbridgeServer) -> None:
    async with driving(server, topic="/{robot}/nowhere") as it:
        assert await it.ended() == "nobody listens on /robot_0/nowhere"
        assert it.frames == []


async def test_another_type(server: RosbridgeServer) -> None:
    async with driving(server, topic="/{robot}/goal") as it:
        told = "/robot_0/goal has type geometry_msgs/PoseStamped, not geometry_msgs/Twist or"
        assert (await it.ended()).startswith(told)
        assert it.frames == []


async def test_without_rosapi_nobody_knows_who_listens(server: RosbridgeServer) -> None:
    play(server, [("dead-rosapi", R0)])
    async with driving(server) as it:
        assert await it.ended() == "rosapi does not tell who listens on /robot_0/cmd_vel"
        assert it.frames == []
