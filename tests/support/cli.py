"""The command line against a loopback simulator, as another program would run it."""

import asyncio
import json
import os
import sys
import tempfile
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.driven_time import TIME
from tests.support.polling import HANGS
from tests.support.warm_cli import warm_cli

ROBOT = '[[robots]]\nname = "{}"\n'


@dataclass(frozen=True)
class Ended:
    """The end of a command."""

    code: int
    out: str
    err: str


def config_file(folder: Path, url: str, robots: int = 1, floors: int = 1) -> Path:
    """A config for the simulator."""
    text = f'[rosbridge]\nurl = "{url}"\n'
    text += "".join(f'[[floors]]\nname = "floor_{n}"\n' for n in range(floors))
    text += "".join(ROBOT.format(f"robot_{n}") for n in range(robots))
    text += '[profile.topics]\npaused = "/{robot}/paused"\n'
    path = folder / "config.toml"
    path.write_text(text)
    return path


async def started(
    folder: Path, *args: str, stdin: int = asyncio.subprocess.DEVNULL
) -> asyncio.subprocess.Process:
    """`fleet-tui` with the config of a folder, running."""
    return await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        "fleet_tui",
        *args,
        cwd=folder,
        env=_environment(folder),
        stdin=stdin,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
    )


async def run(
    folder: Path,
    *args: str,
    stdin: str | None = None,
    within: float = HANGS,
    on_start: Callable[[int], object] = lambda _pid: None,
) -> Ended:
    """Run `fleet-tui` with the config of a folder to its end, while this loop goes on serving; `on_start`
    gets its process id."""
    TIME.be_real()
    with ExitStack() as opened:
        given, out, err = (opened.enter_context(tempfile.TemporaryFile()) for _ in range(3))
        given.write((stdin or "").encode())
        given.seek(0)
        streams = [given.fileno(), out.fileno(), err.fileno()]
        ended = opened.enter_context(warm_cli().start(args, folder, _environment(folder), streams))
        ended.setblocking(False)
        loop, told = asyncio.get_running_loop(), b""
        async with asyncio.timeout(within):
            while b" " not in told:
                told += await loop.sock_recv(ended, 20)
            pid, _, code_told = told.partition(b" ")
            on_start(int(pid))
            code = int(code_told or await loop.sock_recv(ended, 20))
        said = [(file.seek(0), file.read().decode())[1] for file in (out, err)]
    return Ended(code, *said)


def _environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "COLUMNS": "100"}


def asked(server: RosbridgeServer) -> list[str]:
    """The calls that reached the wire: the robot and the service."""
    return [service.replace("/Application_layout/", " ")[1:] for service, _ in server.bridge.services.calls]


def audited(folder: Path) -> list[str]:
    """The commands in the audit log: robot, command, stage."""
    lines = (folder / "fleet-tui" / "audit.jsonl").read_text().splitlines()
    records = [json.loads(line) for line in lines]
    return [
        f"{one.get('robot', '')} {one['what']} {one['change']}".strip()
        for one in records
        if one.get("kind") == "command"
    ]
