"""P15: 1,000 robots (pose 5 Hz, four topics at 2 Hz) over four links, and the curve of smaller fleets before.

Run: python -m tests.bench.bench_fleet_size [--minutes 30] (then of 1,000 robots alone)
"""

import argparse
import json
import random
import statistics
import sys
import tempfile
import time
from bisect import bisect_left, bisect_right
from contextlib import ExitStack
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from tests.bench.rows import Row, p95, row
from tests.support.in_pty import Terminal, serving

CURVE = 1, 10, 100, 300, 1000
PER_BRIDGE = 250
SETTLE, SECONDS = 10.0, 15.0
BETWEEN = 0.11, 0.37
"""Seconds from a key to the next one: at any moment of the tick."""
EVERY = ["--port", "0", "--stop-with-stdin", "--floors", "1", "--rate", "5"]
PROCESS, KEY, MEGABYTES, ALARMS = 80.0, 50.0, 200.0, 10.0
AT_START, SHOWN_WITHIN = 100, 3.0


@dataclass(frozen=True)
class Figures:
    """Per cent of a core of screen thread and process; MB; kB/s to the terminal; milliseconds from keys to
    the paint; messages a second, and how many were dropped or overtaken; robots that were called offline;
    alarms a minute."""

    screen: float
    process: float
    megabytes: float
    kilobytes: float
    keys: list[float]
    messages: float
    dropped: int
    overtaken: int
    offline: int
    alarms: float


def config(folder: Path, urls: list[str], robots: int, floors: int = 1) -> Path:
    """A link for each bridge, some floors."""
    text = f'[rosbridge]\nurl = "{urls[0]}"\n'
    text += "".join(f'[links.hall_{n}]\nurl = "{url}"\n' for n, url in enumerate(urls) if n)
    text += "".join(f'[[floors]]\nname = "floor_{n}"\n' for n in range(floors))
    for n in range(robots):
        hall = n // PER_BRIDGE
        text += f'[[robots]]\nname = "robot_{n}"\n' + (f'link = "hall_{hall}"\n' if hall else "")
    path = folder / "config.toml"
    path.write_text(text)
    return path


def bridges(stack: ExitStack, robots: int) -> list[str]:
    """The addresses of simulators for so many robots."""
    urls = []
    for first in range(0, robots, PER_BRIDGE):
        count = min(PER_BRIDGE, robots - first)
        fleet = ["--robots", str(count), "--first", str(first)]
        urls.append(stack.enter_context(serving("fleet_tui", "sim", *EVERY, *fleet))[0])
    return urls


def pressed(terminal: Terminal, seconds: float) -> list[float]:
    """The times of many zoom keys, over so many seconds."""
    rng, times, end = random.Random(3), list[float](), time.monotonic() + seconds
    while time.monotonic() < end:
        times.append(terminal.press("+-"[len(times) % 2]))
        time.sleep(rng.uniform(*BETWEEN))
    return times


def painted(terminal: Terminal, times: list[float], noted: dict[str, list[Any]]) -> list[float]:
    """Milliseconds from each key until the first write after its handler has come."""
    handled, arrived = noted["handler"][-len(times) :], [at for at, _ in terminal.chunks]
    written = [noted["write"][bisect_right(noted["write"], at)] for at in handled]
    answers = [arrived[bisect_left(arrived, at)] for at in written]
    return [(late - early) * 1000 for early, late in zip(times, answers, strict=True)]


def measured(robots: int, seconds: float = SECONDS) -> Figures:
    """The figures of a fleet of so many robots."""
    with tempfile.TemporaryDirectory() as name, ExitStack() as stack:
        urls, noted = bridges(stack, robots), Path(name) / "noted.json"
        start = ["tests.bench.probe", str(noted), "truth", "keys", "--"]
        settings = ["--config", str(config(Path(name), urls, robots))]
        terminal = Terminal([sys.executable, "-m", *start, *settings], Path(name))
        try:
            terminal.wait_for(f"{robots} of {robots} online", 60.0)
            time.sleep(SETTLE)
            chunks, begun, before = len(terminal.chunks), time.monotonic(), terminal.cpu()
            times = pressed(terminal, seconds)
            took, after = time.monotonic() - begun, terminal.cpu()
            size, megabytes = sum(len(data) for _, data in terminal.chunks[chunks:]), terminal.megabytes()
        finally:
            terminal.close()
        found = json.loads(noted.read_text())
        keys = painted(terminal, times, found)
        looks = [one for one in found["truth"] if begun <= one["at"] <= begun + took]
    screen, process = ((late - early) / took * 100 for early, late in zip(before, after, strict=True))
    first, last = looks[0], looks[-1]
    return Figures(
        *(screen, process, megabytes, size / took / 1000, keys),
        (last["messages"] - first["messages"]) / (last["at"] - first["at"]),
        last["dropped"],
        last["overtaken"] - first["overtaken"],
        robots - min(one["online"] for one in looks),
        (last["raised"] - first["raised"]) / (last["at"] - first["at"]) * 60,
    )


def paused(robots: int) -> float:
    """Seconds from `P` in the console to the last robot's call, by the times in the audit log."""
    with tempfile.TemporaryDirectory() as name, ExitStack() as stack:
        settings = config(Path(name), bridges(stack, robots), robots)
        terminal = Terminal([sys.executable, "-m", "fleet_tui", "--config", str(settings)], Path(name))
        try:
            terminal.wait_for(f"{robots} of {robots} online", 60.0)
            time.sleep(SETTLE)
            begun = time.time()
            terminal.press("P")
            terminal.wait_for("pause all: ", 30.0)
            time.sleep(SETTLE)
        finally:
            terminal.close()
        (log,) = Path(name).rglob("audit.jsonl")
        records = [json.loads(line) for line in log.read_text().splitlines()]
    sent = [one["time"] for one in records if one["change"] == "sent"]
    if len(sent) != robots:
        raise AssertionError(f"{len(sent)} of {robots} were sent a pause")
    return datetime.fromisoformat(max(sent)).timestamp() - begun


def started() -> list[float]:
    """Seconds from the link to a bridge that takes 20 ms for a subscription until the labels of the shown
    floor, the poses of a hundred robots on two floors, and the last subscription."""
    fleet = ["--port", "0", "--stop-with-stdin", "--floors", "2", "--robots", str(AT_START)]
    with tempfile.TemporaryDirectory() as name, serving("tests.bench.slow_bridge_sim", *fleet) as (url, _):
        noted, settings = Path(name) / "noted.json", config(Path(name), [url], AT_START, 2)
        command = ["tests.bench.probe", str(noted), "starts", "--", "--config", str(settings)]
        terminal = Terminal([sys.executable, "-m", *command], Path(name))
        try:
            terminal.wait_for("subscribing", 20.0)
            terminal.wait_for(f"{AT_START} of {AT_START} online", 60.0)
            while "subscribing" in terminal.text():
                time.sleep(0.2)
            time.sleep(1.0)
        finally:
            terminal.close()
        up, *later = json.loads(noted.read_text())["started"]
        return [at - up for at in later]


def rows(robots: int, found: Figures) -> list[Row]:
    """The rows of a fleet; those of the largest have targets."""
    what, is_target = f"{robots} robots: ", robots == CURVE[-1]
    targets = (PROCESS, KEY, MEGABYTES, 0, 0, ALARMS) if is_target else (None,) * 6
    process, key, megabytes, dropped, offline, alarms = targets
    return [
        row("P15", what + "screen thread", found.screen, "%"),
        row("P15", what + "process", found.process, "%", process),
        row("P15", what + "memory", found.megabytes, "MB", megabytes),
        row("P15", what + "to the terminal", found.kilobytes, "kB/s"),
        row("P15", what + "key -> painted, median", statistics.median(found.keys), "ms"),
        row("P15", what + "key -> painted, p95", p95(found.keys), "ms", key),
        row("P15", what + "messages", found.messages, "/s"),
        row("P15", what + "messages dropped", found.dropped, "messages", dropped),
        row("P15", what + "poses overtaken", found.overtaken, "messages"),
        row("P15", what + "robots called offline", found.offline, "robots", offline),
        row("P15", what + "new alarms a minute", found.alarms, "alarms", alarms),
    ]


def main() -> list[Row]:
    labels, poses, last = started()
    what = f"{AT_START} robots, 20 ms for a subscription: link -> "
    found = [
        row("P15", what + "labels of the floor", labels, "s"),
        row("P15", what + "and all robots", poses, "s", SHOWN_WITHIN),
        row("P15", what + "last subscription", last, "s"),
    ]
    largest = CURVE[-1]
    what = f"in the console, {largest} robots: P -> last call on the wire"
    found.append(row("P15", what, paused(largest), "s"))
    return found + [one for robots in CURVE for one in rows(robots, measured(robots))]


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--minutes", type=float, default=0.0)
    if minutes := parser.parse_args().minutes:
        rows(CURVE[-1], measured(CURVE[-1], minutes * 60))
    else:
        main()
