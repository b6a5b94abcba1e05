"""Three simulated fleets of Open-RMF behind one bridge. Argument: the number of robots."""

import asyncio
import sys

from fleet_tui.simulator.rmf.fleet import RmfFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer

FLEETS = ("tiny", "carrier", "cleaner")


async def serve(robots: int) -> None:
    server = RosbridgeServer(RmfFleet(robots, 1, fleets=FLEETS), dialect=ROS2)
    await server.start()
    print(server.url, flush=True)
    await asyncio.to_thread(sys.stdin.read)
    await server.stop()


if __name__ == "__main__":
    asyncio.run(serve(int(sys.argv[1])))
