"""The command line without its imports: a process that has done them forks for each command.

A request is a packet with arguments, folder and environment, and with four descriptors: standard input,
output and error of the command, and a socket that gets its process id and exit code.
"""

import atexit
import importlib
import json
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

PARTS = (
    *("main", "__main__", "console.shell", "console.simulate", "console.replay", "console.demo"),
    *("cli.chosen", "cli.orders.giving", "cli.config.init", "cli.config.origins", "cli.status.status"),
    *("features.serve.cli", "features.recording.cli", "features.doctor.run", "records.audit.log"),
    *("links.fleet_link", "records.recording.incident", "maps.images"),
)
MOST = 2**18
"""Maximum bytes of a request."""


class WarmCli:
    """The process that forks. It ends with the one that began it."""

    def __init__(self) -> None:
        self._requests, there = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        command = [sys.executable, "-m", __name__, str(there.fileno())]
        subprocess.Popen(command, pass_fds=[there.fileno()], stdin=subprocess.DEVNULL)
        there.close()

    def start(
        self, args: Sequence[str], cwd: Path, env: Mapping[str, str], streams: Sequence[int]
    ) -> socket.socket:
        """Start a command on these standard streams. The socket gets its process id, then its exit code."""
        ours, theirs = socket.socketpair()
        request = json.dumps([list(args), str(cwd), dict(env)]).encode()
        with theirs:
            socket.send_fds(self._requests, [request], [*streams, theirs.fileno()])
        return ours


_LOCK = threading.Lock()
_WARM: list[WarmCli] = []


def warm_cli() -> WarmCli:
    """The one of this process."""
    with _LOCK:
        if not _WARM:
            _WARM.append(WarmCli())
    return _WARM[0]


STARVED = "FLEET_TUI_STARVED"
"""Name of a variable with that of a thread which gets a processor last."""


def _starve(name: str) -> None:
    real = threading.Thread.start

    def start(thread: threading.Thread) -> None:
        real(thread)
        if thread.name == name and thread.native_id is not None:
            os.setpriority(os.PRIO_PROCESS, thread.native_id, 19)

    threading.Thread.start = start  # type: ignore[assignment,method-assign]  # in a process of its own


def _be(args: list[str], cwd: str, env: dict[str, str], streams: list[int]) -> int:
    """Be the command, in a child."""
    for number, stream in enumerate(streams):
        os.dup2(stream, number)
    os.chdir(cwd)
    os.environ.clear()
    os.environ.update(env)
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    _starve(env.get(STARVED, ""))
    sys.argv = [str(Path(importlib.import_module("fleet_tui").__path__[0]) / "__main__.py"), *args]
    from fleet_tui.__main__ import main

    try:
        main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    finally:
        atexit._run_exitfuncs()
        with suppress(OSError, ValueError):
            sys.stdout.flush()
    return 0


def _fork(request: bytes, descriptors: list[int]) -> None:
    """Start a command, and a child that waits for its end: this one goes on."""
    if os.fork():
        for descriptor in descriptors:
            os.close(descriptor)
        return
    *streams, answer = descriptors
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    child = os.fork()
    if not child:
        os.close(answer)
        code = 1
        try:
            args, cwd, env = json.loads(request)
            code = _be(args, cwd, env, streams)
        finally:
            os._exit(code)
    os.write(answer, f"{child} ".encode())
    _, status = os.waitpid(child, 0)
    os.write(answer, str(os.waitstatus_to_exitcode(status)).encode())
    os._exit(0)


def main() -> None:
    requests = socket.socket(fileno=int(sys.argv[1]))
    for name in PARTS:
        importlib.import_module(f"fleet_tui.{name}")
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    while True:
        request, descriptors, _, _ = socket.recv_fds(requests, MOST, 4)
        if not request:
            return
        _fork(request, descriptors)


if __name__ == "__main__":
    main()
