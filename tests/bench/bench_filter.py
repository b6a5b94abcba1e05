"""P26: from a letter of a filter over 500 robots to the painted rows in the terminal.

Run: python -m tests.bench.bench_filter
"""

import json
import random
import tempfile
import time
from bisect import bisect_left
from pathlib import Path

from tests.bench.rows import Row, p95, row
from tests.support.in_pty import console, simulator

FILTERS, REPEATS = 25, 3
RATE = 2.0  # poses per second and robot: as many messages as of 100 robots at the usual rate


def painted(robots: int) -> list[float]:
    """Milliseconds from each letter to the arrival of the first write after its rows were made."""
    rng = random.Random(5)
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "log"
        with simulator(robots, RATE) as url, console(url, robots, [str(log), "filters"]) as terminal:
            terminal.wait_for(f"{robots} of {robots} online", 60.0)
            times = []
            for _ in range(FILTERS):
                terminal.press("/")
                time.sleep(0.2)
                for letter in f"{rng.randrange(robots):03}":
                    times.append(terminal.press(letter))
                    time.sleep(rng.uniform(0.08, 0.16))
                terminal.press("\x1b")
                time.sleep(0.3)
        noted = json.loads(log.read_text())
        arrived = [at for at, _ in terminal.chunks]
        made = [at for at, typed in noted["filter"] if typed]
        shown = [arrived[bisect_left(arrived, at)] for at in made]
    assert len(made) == len(times), "a letter was lost"
    return [(late - early) * 1000 for early, late in zip(times, shown, strict=True)]


def main() -> list[Row]:
    few, many = (min((painted(robots) for _ in range(REPEATS)), key=p95) for robots in (10, 500))
    return [
        row("P26", "letter of a filter -> painted, 10 robots, p95", p95(few), "ms"),
        row(
            "P26",
            "letter of a filter -> painted, 500 robots, p95",
            p95(many),
            "ms",
            20.0,
            p95(few),
            "10 robots",
        ),
    ]


if __name__ == "__main__":
    main()
