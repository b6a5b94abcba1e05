"""The console at work for as long as asked: does anything grow, does it get slower?

100 robots, 1,800 messages a second, a key now and then. Run: python -m tests.bench.soak
"""

import argparse
import json
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path

from tests.support.in_pty import Terminal, console, simulator

ROBOTS = 100
BETWEEN = 0.1
"""Seconds from one robot to the next, at first."""
JUDGED, MOST = 30.0, 0.1
"""Of so many minutes a run must be to fail at all, by so many MB a minute: in the first ten, buffers fill up
to their limits, and over a few minutes the live maps that come and go count for more."""
KEYS = "+t]m}-e*v{h]m0[m"


@dataclass(frozen=True)
class Sample:
    """The console's process at one moment; `answer` is how long it took to say something to a key."""

    at: float
    megabytes: float
    threads: int
    files: int
    answer: float


def look(terminal: Terminal, started: float, key: str) -> Sample:
    """One sample, with one key pressed for it."""
    proc = Path(f"/proc/{terminal.pid}")
    threads, files = len(list((proc / "task").iterdir())), len(list((proc / "fd").iterdir()))
    chunks, pressed = len(terminal.chunks), terminal.press(key)
    while len(terminal.chunks) == chunks and time.monotonic() - pressed < 2.0:
        time.sleep(0.0005)
    answer = terminal.chunks[-1][0] - pressed
    return Sample(time.monotonic() - started, terminal.megabytes(), threads, files, answer)


def soak(seconds: float, robots: int = ROBOTS) -> tuple[list[Sample], list[int]]:
    """Samples, one a second, and how many asyncio tasks there were at each."""
    with tempfile.TemporaryDirectory() as folder, simulator(robots) as url:
        tasks = Path(folder) / "tasks.json"
        with console(url, robots, [str(tasks), "tasks"]) as terminal:
            terminal.wait_for(f"{robots} of {robots} online")
            for _ in range(robots):
                terminal.press("]")  # what is kept of a robot that was looked at once is kept of all
                time.sleep(BETWEEN)
            started, keys, samples = time.monotonic(), cycle(KEYS), []
            while time.monotonic() - started < seconds:
                samples.append(look(terminal, started, next(keys)))
                time.sleep(1.0)
        return samples, json.loads(tasks.read_text())["task"]


def growth(samples: list[Sample]) -> float:
    """MB a minute in the second half, as the line through its samples has it: what leaks goes on to grow."""
    late = [one for one in samples if one.at >= samples[-1].at / 2]
    slope, _ = statistics.linear_regression([one.at for one in late], [one.megabytes for one in late])
    return slope * 60


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--minutes", type=float, default=30.0)
    minutes = parser.parse_args().minutes
    samples, tasks = soak(minutes * 60)
    print("    min     MB  threads  files  tasks  answer ms")
    for one, count in list(zip(samples, tasks, strict=False))[:: max(1, len(samples) // 30)]:
        counts = f"{one.threads:8d} {one.files:6d} {count:6d}"
        print(f"{one.at / 60:7.1f} {one.megabytes:6.1f} {counts} {one.answer * 1000:10.1f}")
    third = len(samples) // 3 or 1
    early, late = (
        statistics.median(one.answer for one in part) for part in (samples[:third], samples[-third:])
    )
    slope = growth(samples)
    print(f"memory {slope:+.2f} MB a minute; answer {early * 1000:.1f} -> {late * 1000:.1f} ms")
    sys.exit(minutes >= JUDGED and slope > MOST)


if __name__ == "__main__":
    main()
