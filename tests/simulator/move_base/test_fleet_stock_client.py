"""A stock client of actionlib gets on with the simulated move_base."""

import asyncio
import json
import subprocess
import sys
from pathlib import Path

from fleet_tui.simulator.move_base.navigation import REACHED
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.polling import HANGS

PROGRAM = Path(__file__).parent / "stock_actions.py"


async def test_roslibpy_drives_a_robot_and_cancels_a_drive(server: RosbridgeServer) -> None:
    process = await asyncio.create_subprocess_exec(
        sys.executable, str(PROGRAM), server.url, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    try:
        async with asyncio.timeout(HANGS):
            out, err = await process.communicate()
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    assert process.returncode == 0, err.decode()
    found = json.loads(out)
    assert found["ends"] == [[3, REACHED], [2, ""]]
    assert found["feedback"]["base_position"]["header"]["frame_id"] == "map"
