"""P9: a map of 4000 x 4000 arrives while the console runs: by how much its screen's loop is late.

Run: python -m tests.bench.bench_live_map
"""

import json
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

from tests.bench.big_map_server import SIDE
from tests.bench.rows import Row, row
from tests.support.in_pty import Terminal, console, serving, shows_racks

ROBOTS = 10
QUIET = 5.0  # seconds with nothing special, to compare with
SHOWN_WITHIN = 20.0
AFTER = 2.0
GAP, RSS = 50.0, 110.0


def worst(noted: dict[str, list[Any]], start: float, end: float) -> float:
    """The most, in ms, by which a beat came late."""
    late: list[float] = [late for at, late in noted["beat"] if start < at < end]
    return max(late) * 1000


def arrive(kind: str) -> tuple[float, float, float, float]:
    """The loop's worst gap before and while the map comes, seconds until it shows, MB after."""
    with (
        tempfile.TemporaryDirectory() as folder,
        serving("tests.bench.big_map_server", str(ROBOTS)) as (url, server),
    ):
        log = Path(folder) / "log"
        with console(url, ROBOTS, [str(log), "beats"]) as terminal:
            asked, end, megabytes = watched(terminal, server, kind)
        noted = json.loads(log.read_text())
    came = next(at for at, width in noted["map"] if width == SIDE)
    return worst(noted, asked - QUIET, asked), worst(noted, asked, end), came - asked, megabytes


def watched(terminal: Terminal, server: subprocess.Popen[bytes], kind: str) -> tuple[float, float, float]:
    """When the map was sent and when the watch ended, and MB then. Raises TimeoutError if it is not shown."""
    terminal.wait_for(f"{ROBOTS} of {ROBOTS} online")
    terminal.wait_for("Consumidores")
    time.sleep(QUIET)
    asked = time.monotonic()
    tell(server, kind)
    time.sleep(SHOWN_WITHIN / 4)
    terminal.press("0")
    while not shows_racks(terminal):
        if time.monotonic() > asked + SHOWN_WITHIN:
            raise TimeoutError(f"the map as {kind} was never shown\n{terminal.text()}")
        time.sleep(0.2)
    time.sleep(AFTER)
    return asked, time.monotonic(), terminal.megabytes()


def tell(server: subprocess.Popen[bytes], kind: str) -> None:
    assert server.stdin is not None
    server.stdin.write(f"{kind}\n".encode())
    server.stdin.flush()


def main() -> list[Row]:
    rows = []
    for kind in ("cbor", "png", "json"):
        before, gap, seconds, megabytes = arrive(kind)
        what = f"live map {SIDE} x {SIDE} as {kind}"
        rows += [
            row("P9", f"{what}: loop gap", gap, "ms", GAP, before, "before the map came"),
            row("P9", f"{what}: sent -> shown", seconds, "s"),
            row("P10", f"{what}: memory after", megabytes, "MB", RSS if kind == "cbor" else None),
        ]
    return rows


if __name__ == "__main__":
    main()
