"""The command line against a loopback simulator, as another program would run it."""

import asyncio
import atexit
import io
import json
import logging
import os
import signal
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, chdir, contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from unittest.mock import patch

from fleet_tui.__main__ import run as command_line
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


async def run(folder: Path, *args: str, stdin: str = "") -> Ended:
    """Run the command line with the config of a folder to its end, in a thread with driven seconds, while
    this loop goes on serving."""
    return await asyncio.to_thread(command, args, folder, _environment(folder), stdin)


_ONE = threading.Lock()


def command(args: Sequence[str], folder: Path, env: Mapping[str, str], stdin: str = "") -> Ended:
    """Run the command line to its end as if it were a process: one at a time, and no signal reaches it."""
    given, out, err = (io.TextIOWrapper(io.BytesIO(text.encode())) for text in (stdin, "", ""))
    code: object = 0
    with (
        _ONE,
        _as_a_process(folder, env),
        redirect_stdout(out),
        redirect_stderr(err),
        patch.object(sys, "stdin", given),
        patch.object(sys, "argv", ["fleet-tui", *args]),
    ):
        try:
            command_line()
        except SystemExit as end:
            code = end.code
    out.flush()
    err.flush()
    said = (stream.buffer.getvalue().decode() for stream in (out, err))
    return Ended(code if isinstance(code, int) else int(code is not None), *said)


@contextmanager
def _as_a_process(folder: Path, env: Mapping[str, str]) -> Iterator[None]:
    """Have the folder, environment, log and end of a process of its own."""
    ends: list[Callable[[], object]] = []
    root = logging.getLogger()
    handlers, level = root.handlers[:], root.level
    with (
        chdir(folder),
        patch.dict(os.environ, env, clear=True),
        patch.object(signal, "signal", lambda _number, _handler: signal.SIG_DFL),
        patch.object(asyncio.SelectorEventLoop, "add_signal_handler", lambda *_: None),
        patch.object(atexit, "register", ends.append),
    ):
        try:
            yield
        finally:
            for end in reversed(ends):
                end()
            for handler in set(root.handlers) - set(handlers):
                root.removeHandler(handler)
            root.setLevel(level)


async def run_alone(
    folder: Path,
    *args: str,
    stdin: str | None = None,
    within: float = HANGS,
    on_start: Callable[[int], object] = lambda _pid: None,
) -> Ended:
    """Run `fleet-tui` as a process of its own, in real seconds; `on_start` gets its process id."""
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
