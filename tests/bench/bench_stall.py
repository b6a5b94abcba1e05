"""P8: a terminal that is not read for 5 s, against stock Textual in the same run.

Run: python -m tests.bench.bench_stall
"""

import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
from pathlib import Path

import pyte

from tests.bench.rows import Row, row

WIDTH, HEIGHT = 200, 60
STALL, STEPS = 5.0, 50  # seconds, keys pressed in them
TARGET = 150.0  # milliseconds


def read(master: int, stream: pyte.ByteStream, seconds: float) -> None:
    """Be a terminal that reads."""
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0:
        if select.select([master], [], [], left)[0]:
            stream.feed(os.read(master, 65536))


def clock_lag(screen: pyte.Screen) -> float:
    """Seconds by which the clock on the screen is behind."""
    found = re.search(r"(\d\d):(\d\d):(\d\d)", "\n".join(screen.display[:2]))
    if found is None:
        return float("inf")
    hours, minutes, seconds = map(int, found.groups())
    local = time.localtime()
    return local.tm_hour * 3600 + local.tm_min * 60 + local.tm_sec - (hours * 3600 + minutes * 60 + seconds)


def stall(kind: str) -> tuple[float, bool, float]:
    """The longest gap of the loop in ms, whether a command went out, seconds the picture is behind after."""
    screen = pyte.Screen(WIDTH, HEIGHT)
    stream = pyte.ByteStream(screen)
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", HEIGHT, WIDTH, 0, 0))
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "log"
        child = subprocess.Popen(
            [sys.executable, "-m", "tests.bench.stalled_console", str(log), kind],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            start_new_session=True,
            env={**os.environ, "TERM": "xterm-256color", "COLORTERM": "truecolor"},
        )
        read(master, stream, 6.0)
        start = time.monotonic()
        # The operator goes on zooming, and pauses the robot: nothing of it is seen.
        for step in range(STEPS):
            os.write(master, b"p" if step == STEPS // 2 else b"+-"[step % 2 :][:1])
            time.sleep(STALL / STEPS)
        end = time.monotonic()
        read(master, stream, 0.5)
        behind = clock_lag(screen)
        lines = [line.split() for line in log.read_text().splitlines()]
        os.killpg(child.pid, signal.SIGKILL)
        child.wait()
    os.close(slave)
    os.close(master)
    gaps = [float(gap) for what, at, gap in lines if what == "gap" and float(at) > start]
    called = any(what == "call" and start < float(at) < end for what, at, _ in lines)
    return max(gaps, default=0.0) * 1000, called, behind


def main() -> list[Row]:
    (gap, sent, behind), (stock, *_) = stall("lean"), stall("stock")
    what = f"terminal not read for {STALL:g} s: "
    return [
        row("P8", what + "loop gap", gap, "ms", TARGET, stock, "stock Textual"),
        row("P8", what + "commands that did not go out", float(not sent), "of 1", 0),
        row("P8", what + "picture behind 0.5 s after", behind, "s", 1),
    ]


if __name__ == "__main__":
    main()
