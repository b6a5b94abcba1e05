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
from typing import Any

import pyte

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


def main() -> list[dict[str, Any]]:
    measured = {kind: stall(kind) for kind in ("lean", "stock")}
    for kind, (gap, called, behind) in measured.items():
        print(
            f"P8 {kind}: not read for {STALL:g} s: loop gap {gap:.0f} ms (target {TARGET:g}), command"
            f" {'went out' if called else 'did NOT go out'}, picture {behind:g} s behind 0.5 s after"
        )
    lean, stock = measured["lean"], measured["stock"]
    return [
        {
            "id": "P8",
            "what": "event loop gap while the terminal is not read for 5 s, ms",
            "figure": lean[0],
            "target": TARGET,
            "ratio": lean[0] / stock[0] if stock[0] else 1.0,
            "against": f"stock Textual ({stock[0]:.0f} ms)",
            "command_sent": lean[1],
            "seconds_behind_after": lean[2],
        }
    ]


if __name__ == "__main__":
    main()
