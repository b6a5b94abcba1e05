"""P6: from a key in the terminal to its handler, and to the painted answer back in the terminal.

Run: python -m tests.bench.bench_keys
"""

import json
import random
import tempfile
import time
from bisect import bisect_left, bisect_right
from pathlib import Path

from tests.bench.rows import Row, p95, row
from tests.support.in_pty import console, simulator

KEYS, REPEATS = 200, 3
SETTLE = 4.0


def pressed(robots: int, follow: bool) -> tuple[list[float], list[float]]:
    """Milliseconds to the handler and to the paint of zoom keys, at any moment of the tick."""
    rng = random.Random(3)
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "log"
        with simulator(robots) as url, console(url, robots, [str(log), "keys"]) as terminal:
            terminal.wait_for(f"{robots} of {robots} online")
            for key in "f+++" if follow else "":
                terminal.press(key)
            time.sleep(SETTLE)
            times = []
            for n in range(KEYS):
                times.append(terminal.press("+-"[n % 2]))
                time.sleep(rng.uniform(0.08, 0.16))
        noted = json.loads(log.read_text())
        handled = noted["handler"][-KEYS:]
        arrived = [at for at, _ in terminal.chunks]
        # The first write after the handler carries the answer; it is painted when it has arrived.
        written = [noted["write"][bisect_right(noted["write"], at)] for at in handled]
        painted = [arrived[bisect_left(arrived, at)] for at in written]
    to_handler = [(late - early) * 1000 for early, late in zip(times, handled, strict=True)]
    to_paint = [(late - early) * 1000 for early, late in zip(times, painted, strict=True)]
    return to_handler, to_paint


def undisturbed(robots: int, follow: bool) -> tuple[list[float], list[float]]:
    """Of some runs the one that was disturbed least by what else the machine does."""
    return min((pressed(robots, follow) for _ in range(REPEATS)), key=lambda run: p95(run[1]))


def main() -> list[Row]:
    idle, painted = undisturbed(1, False)
    busy, busy_painted = undisturbed(100, True)
    return [
        row("P6", "key -> handler, 1 robot, p95", p95(idle), "ms", 2.0),
        row("P6", "key -> painted, 1 robot, p95", p95(painted), "ms", 6.0),
        row("P6", "key -> handler, 100 robots, follow, p95", p95(busy), "ms", 8.0, p95(idle), "1 robot"),
        row(
            "P6",
            "key -> painted, 100 robots, follow, p95",
            p95(busy_painted),
            "ms",
            None,
            p95(painted),
            "1 robot",
        ),
    ]


if __name__ == "__main__":
    main()
