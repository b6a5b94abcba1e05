"""A command in a session of its own where systemd is absent: it outlives the console that started it.

Run as a module. It ends once the command has begun, and leaves a process that writes the command's bounded
log, passes on SIGTERM, and keeps the outcome in a locked file: as long as the lock is held, the command runs.
"""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import IO

from fleet_tui.storage.handles import open_private
from fleet_tui.storage.lock import lock
from fleet_tui.text.language import Message

FILE_SUFFIX = ".session"
LOG_SUFFIX = ".log"
LARGEST_LOG = 5 * 2**20
"""Bytes after which the log becomes NAME.log.1."""
GRACE = 15
"""Seconds for a command to end by SIGTERM: roslaunch takes its time."""
RECORD = 256
"""Bytes of the record in the file. They are written at once, so that no reader finds half of it."""
LOCK_WITHIN = 0.5
"""Seconds to wait for the lock, which a look at the session takes for a moment."""


def start(folder: Path, name: str, command: Sequence[str]) -> str:
    """Start a command, and return the reason if that failed."""
    file = open_private(folder / f"{name}{FILE_SUFFIX}", os.O_RDWR | os.O_CREAT)
    if not lock(file, LOCK_WITHIN):
        return Message("is already running")
    reader, writer = os.pipe()
    if os.fork():
        os.close(writer)
        with os.fdopen(reader) as said:
            return said.read()
    os.close(reader)
    os.setsid()
    nothing = os.open(os.devnull, os.O_RDWR)
    for stream in range(3):
        os.dup2(nothing, stream)
    _keep(file, writer, folder / f"{name}{LOG_SUFFIX}", command)
    os._exit(0)


def _keep(file: int, writer: int, log: Path, command: Sequence[str]) -> None:
    """Run the command to its end."""
    out = subprocess.PIPE
    try:
        child = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT, process_group=0
        )
    except OSError as problem:
        os.write(
            writer,
            Message(
                "{command}: {strerror}: check `start` in [[programs]]",
                command=command[0],
                strerror=problem.strerror,
            ).encode(),
        )
        return
    instance = f"{child.pid}-{time.time_ns()}"
    stopped = _stop_on_signal(child)
    _record(file, instance, None, False)
    os.close(writer)
    assert child.stdout is not None
    copying = threading.Thread(target=_copy, args=(child.stdout, log), daemon=True)
    copying.start()
    code = child.wait()
    copying.join(1.0)
    _record(file, instance, code, stopped.is_set())


def _stop_on_signal(child: subprocess.Popen[bytes]) -> threading.Event:
    """Pass SIGTERM on to the command and its group, after a while as SIGKILL."""
    stopped = threading.Event()

    def end(number: int, _frame: object) -> None:
        stopped.set()
        signal.alarm(GRACE)
        with suppress(ProcessLookupError):
            os.killpg(child.pid, signal.SIGTERM if number == signal.SIGTERM else signal.SIGKILL)

    for number in (signal.SIGTERM, signal.SIGALRM):
        signal.signal(number, end)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    return stopped


def _record(file: int, instance: str, code: int | None, stopped: bool) -> None:
    fields = {
        "pid": os.getpid(),
        "instance": instance,
        "since": time.time(),
        "code": code,
        "stopped": stopped,
    }
    os.pwrite(file, json.dumps(fields).ljust(RECORD).encode(), 0)


def _copy(output: IO[bytes], log: Path) -> None:
    """Write the output to the log. Where the disk is full it is lost: the command must not wait for it."""
    while block := os.read(output.fileno(), 2**16):
        with suppress(OSError):
            if log.exists() and log.stat().st_size > LARGEST_LOG:
                log.replace(f"{log}.1")
            with os.fdopen(os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600), "ab") as file:
                file.write(block)


def main() -> None:
    """Start the command of the arguments: FOLDER NAME PROGRAM [ARGUMENT ...]."""
    folder, name, *command = sys.argv[1:]
    if problem := start(Path(folder), name, command):
        sys.exit(problem)


if __name__ == "__main__":
    main()
