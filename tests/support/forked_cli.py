"""The command line many times a second: a process that has imported it, and forks for each of them.

Requests are lines of JSON on stdin, each the arguments; answers are lines with how it ended. Nothing leaves
this machine, and what runs for long gets Ctrl-C.
"""

import contextlib
import importlib
import json
import os
import signal
import socket
import sys
import tempfile
import time
import traceback
from typing import Any

PATIENCE, HANGS = 1.0, 8.0
"""Seconds until Ctrl-C, and until it counts as hanging."""
PARTS = (
    *("main", "__main__", "console.shell", "console.simulate", "cli.orders.giving", "cli.config.init"),
    "console.open",
)


def _only_here(host: object, *more: Any, **named: Any) -> Any:
    if host in ("localhost", "127.0.0.1"):
        return _look_up(host, *more, **named)
    raise socket.gaierror(socket.EAI_NONAME, "not known")


_look_up: Any = socket.getaddrinfo


def run(arguments: list[str]) -> int:
    """Be the command line, in a child."""
    from fleet_tui.__main__ import main

    signal.signal(signal.SIGALRM, lambda *_: os.kill(os.getpid(), signal.SIGINT))
    signal.setitimer(signal.ITIMER_REAL, PATIENCE)
    sys.argv = ["fleet-tui", *arguments]
    try:
        main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:  # noqa: BLE001  # a child that goes on would be a second parent
        traceback.print_exc()
        return 1
    return 0


def forked(arguments: list[str]) -> dict[str, Any]:
    with tempfile.TemporaryFile() as output:
        child = os.fork()
        if not child:
            for descriptor in (1, 2):
                os.dup2(output.fileno(), descriptor)
            code = run(arguments)
            with contextlib.suppress(OSError, ValueError):
                sys.stdout.flush()
            os._exit(code)
        began, status = time.monotonic(), 0
        while not (ended := os.waitpid(child, os.WNOHANG))[0]:
            time.sleep(0.002)
            if time.monotonic() - began > HANGS:
                os.kill(child, signal.SIGKILL)
                ended = os.waitpid(child, 0)
                break
        status = os.waitstatus_to_exitcode(ended[1])
        output.seek(0)
        said = output.read().decode("latin-1")
        return {"code": status, "said": said, "took": time.monotonic() - began}


def main() -> None:
    for name in PARTS:
        importlib.import_module(f"fleet_tui.{name}")
    socket.getaddrinfo = _only_here
    answers = os.fdopen(os.dup(1), "w")
    requests = os.fdopen(os.dup(0))
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    for line in requests:
        answers.write(json.dumps(forked(json.loads(line))) + "\n")
        answers.flush()


if __name__ == "__main__":
    main()
