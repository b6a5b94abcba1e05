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


@two_users
def test_a_state_folder_in_which_others_laid_links(tmp_path: Path) -> None:
    state, mine = tmp_path / "state" / "fleet-tui", tmp_path / "mine"
    state.mkdir(parents=True)
    mine.write_text("mine")
    for name in ("audit.jsonl", "fleet-tui.log"):
        (state / name).symlink_to(mine)
    give(state)
    running = InTerminal(["demo"], tmp_path)
    try:
        running.shows("nothing is kept, no log, no audit log: ")
        running.shows("all clear")
    finally:
        running.close()
    assert mine.read_text() == "mine"
    seen = "nothing is kept, and why; nothing is written through their links"
    report("a state folder of another user", "links lie in it", seen, None, None)
