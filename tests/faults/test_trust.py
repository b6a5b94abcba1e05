"""A configuration that another user of the machine wrote: nothing of it runs until a person says so."""

import asyncio
from pathlib import Path

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file
from tests.support.fault_report import report
from tests.support.terminal_session import InTerminal
from tests.support.users import give, two_users

QUESTION = "Trust what is in it now? [y/N]"


@two_users
@pytest.mark.parametrize("answer", ["n", "y"])
async def test_a_configuration_of_another_user(server: RosbridgeServer, tmp_path: Path, answer: str) -> None:
    path = config_file(tmp_path, server.url, 2, 2)
    give(path)
    running = InTerminal(["--config", str(path)], tmp_path)
    try:
        await asyncio.to_thread(running.shows, QUESTION)
        assert "opened without programs and credentials: " in running.text()
        running.press(f"{answer}\r")
        await asyncio.to_thread(running.shows, "robot_1")
        if answer == "n":
            await asyncio.to_thread(running.shows, "opened without programs and cred")
    finally:
        await asyncio.to_thread(running.close)
    seen = "asks; until a yes no programs, credentials, routines, desk, and why"
    report("a configuration of another user", "its file belongs to somebody else", seen, None, None)
