"""P17: the console with 50 robots with Nav2 against the same with 50 of the source's robots, in one run.

Run: python -m tests.bench.bench_nav2
"""

import time

from tests.bench.rows import Row, times_source
from tests.support.in_pty import console, simulator

ROBOTS = 50
SETTLE, SECONDS = 6.0, 20.0
AT_MOST = 1.0
"""Times what the same number of the source's robots cost."""


def busy(kind: str) -> tuple[float, float]:
    """Per cent of a core: screen thread and process."""
    with simulator(ROBOTS, kind=kind) as url, console(url, ROBOTS, kind=kind) as terminal:
        terminal.wait_for(f"{ROBOTS} of {ROBOTS} online")
        time.sleep(SETTLE)
        start, before = time.monotonic(), terminal.cpu()
        time.sleep(SECONDS)
        after, seconds = terminal.cpu(), time.monotonic() - start
    screen, process = ((late - early) / seconds * 100 for early, late in zip(before, after, strict=True))
    return screen, process


def main() -> list[Row]:
    ours, source = busy("nav2"), busy("oh_ressources")
    what = f"{ROBOTS} robots with Nav2"
    return times_source("P17", what, ours, source, f"{ROBOTS} of the source's", AT_MOST)


if __name__ == "__main__":
    main()
