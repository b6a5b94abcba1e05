"""The simulator with a map of 4000 x 4000 for robot_0 that it publishes when a line comes in.

`cbor`: as the console asks a bridge of ROS 1 for it; `png`: as it asks one of ROS 2; `json`: as text, like a
bridge that knows no CBOR. Every line is answered when the frame is on its way; the server ends with its
standard input.
"""

import asyncio
import sys
import time

import numpy as np

from fleet_tui.simulator.frames import Compression, OutgoingFrame, Payload
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.server import RosbridgeServer

SIDE = 4000
TOPIC = "/robot_0/floor_0/map"
ASKED: dict[str, Compression] = {"cbor": "cbor", "png": "png", "json": "none"}
"""The compression of each kind."""


def big_map() -> dict[str, object]:
    """Free ground in a wall, with racks: row 0 is the lower edge."""
    cells = np.zeros((SIDE, SIDE), np.int8)
    cells[:20] = cells[-20:] = cells[:, :20] = cells[:, -20:] = 100
    for row in range(200, SIDE - 200, 200):
        cells[row : row + 60, 300:-300] = 100
    now = ROS1.time(time.time())
    position = {"x": -20.0, "y": -20.0, "z": 0.0}
    origin = {"position": position, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
    info = {"map_load_time": now, "resolution": 0.05, "width": SIDE, "height": SIDE, "origin": origin}
    header = {"seq": 1, "stamp": now, "frame_id": "floor_0"}
    return {"header": header, "info": info, "data": cells.ravel()}


async def serve(robots: int) -> None:
    server = RosbridgeServer(OhFleet(robots, 1, seed=1))
    publication = OutgoingFrame(TOPIC, Payload(big_map()))
    # Made beforehand: making them must not take from the console what is measured.
    frames = {kind: publication.frame(asked) for kind, asked in ASKED.items()}
    await server.start()
    print(server.url, flush=True)
    loop = asyncio.get_running_loop()
    while line := await loop.run_in_executor(None, sys.stdin.readline):
        server.bridge.publish_raw(TOPIC, frames[line.strip()])
        print(line.strip(), flush=True)
    await server.stop()


if __name__ == "__main__":
    asyncio.run(serve(int(sys.argv[1])))
