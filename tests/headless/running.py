"""The command line against a loopback simulator, as another program would run it."""

import asyncio
import os
import sys
from dataclasses import dataclass
from pathlib import Path

ROBOT = '[[robots]]\nname = "{}"\n'


@dataclass(frozen=True)
class Ended:
    """How a command ended."""

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


async def run(folder: Path, *args: str) -> Ended:
    """Run `fleet-tui` with the config of a folder, while this loop goes on serving."""
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        "fleet_tui",
        *args,
        cwd=folder,
        env={**os.environ, "XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "COLUMNS": "100"},
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
    )
    out, err = await asyncio.wait_for(process.communicate(), 30)
    return Ended(process.returncode or 0, out.decode(), err.decode())
