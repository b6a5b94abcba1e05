"""A routine of two robots in fast time: the link is lost, nothing follows, a person resumes."""

import asyncio
import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, config_file
from tests.support.in_pty import Terminal
from tests.support.polling import until
from tests.support.routine_files import routine

MORNING = """\
for robot_0 robot_1
  repeat 2
    carry Base Consumidores
    wait until idle
  end
  run true
end
"""


@pytest.fixture
async def fast() -> AsyncIterator[RosbridgeServer]:
    """Two quiet robots whose time runs ten times as fast."""
    running = RosbridgeServer(OhFleet(robots=2, floors=1, seed=1, quiet=True), speed=10.0)
    await running.start()
    yield running
    await running.stop()


@pytest.mark.nightly
async def test_held_by_a_lost_link_and_resumed_by_a_person(fast: RosbridgeServer, tmp_path: Path) -> None:
    config = config_file(tmp_path, fast.url, 2, 1)
    routine(tmp_path, MORNING)
    command = [sys.executable, "-m", "fleet_tui", "--config", str(config), "routine", "run", "day"]
    terminal = Terminal(command, tmp_path)
    try:
        await until(lambda: len(asked(fast)) == 2)
        await fast.drop_clients()
        await asyncio.to_thread(terminal.wait_for, "Enter: resume with this instruction")
        await until(lambda: not any(robot.orders for robot in fast.world.robots.values()))
        assert len(asked(fast)) == 2, "the running orders went on, nothing followed"
        terminal.press("\r")
        await asyncio.to_thread(terminal.wait_for, "robot_0 done")
        await asyncio.to_thread(terminal.wait_for, "robot_1 done")
        assert len(asked(fast)) == 4
    finally:
        await asyncio.to_thread(terminal.close, "\x03")
