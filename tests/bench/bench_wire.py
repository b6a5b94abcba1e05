"""P11: from the robot's own stamp in a pose to the painted screen, 10 robots, 10 poses a second each.

Run: python -m tests.bench.bench_wire
"""

import json
import tempfile
import time
from bisect import bisect_left
from pathlib import Path
from typing import Any

from tests.bench.rows import Row, p95, row
from tests.support.in_pty import console, simulator

ROBOTS = 10
RATE = 9.9
"""Not quite the console's 10 ticks a second: so every phase between the two occurs."""
SECONDS = 25.0
TICK = 100.0  # milliseconds


def delays(noted: dict[str, list[Any]], clock: float) -> list[float]:
    """Milliseconds from each stamp until it, or a newer one, was painted. `clock`: wall - monotonic."""
    found = []
    ticks = noted["tick"]
    for robot in {robot for robot, _ in noted["pose"]}:
        shown = [tick[2].get(robot, 0.0) for tick in ticks]
        for _, stamp in (pose for pose in noted["pose"] if pose[0] == robot):
            at = bisect_left(shown, stamp)
            if at + 1 < len(ticks):
                done, following = ticks[at][0], ticks[at + 1][0]
                write = bisect_left(noted["write"], done)
                # Where nothing visible changed, nothing is written: the tick's end counts.
                if write < len(noted["write"]) and noted["write"][write] < following:
                    done = noted["write"][write]
                found.append((done + clock - stamp) * 1000)
    return found


def main() -> list[Row]:
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "log"
        with simulator(ROBOTS, RATE) as url, console(url, ROBOTS, [str(log), "poses"]) as terminal:
            terminal.wait_for(f"{ROBOTS} of {ROBOTS} online")
            time.sleep(SECONDS)
        noted = json.loads(log.read_text())
    # The first seconds are the start: charts and maps come too.
    noted["pose"] = noted["pose"][ROBOTS * 30 :]
    found = delays(noted, time.time() - time.monotonic())
    return [row("P11", f"wire -> painted, {ROBOTS} robots, p95 of {len(found)}", p95(found), "ms", TICK + 20)]


if __name__ == "__main__":
    main()
