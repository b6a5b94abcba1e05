"""P30: the console with 100 robots in three fleets of Open-RMF against 100 of the source's, in one run.

Run: python -m tests.bench.bench_rmf
"""

import time

from fleet_tui.simulator.rmf.naming import full_name
from tests.bench.rows import Row, times_source
from tests.bench.three_fleets_sim import FLEETS
from tests.support.in_pty import Terminal, console, serving, simulator

ROBOTS = 100
SETTLE, SECONDS = 6.0, 20.0
AT_MOST = 1.0
"""Times what the same number of the source's robots cost."""


def measured(terminal: Terminal) -> tuple[float, float]:
    """Per cent of a core: screen thread and process."""
    terminal.wait_for(f"{ROBOTS} of {ROBOTS} online", within=40.0)
    time.sleep(SETTLE)
    start, before = time.monotonic(), terminal.cpu()
    time.sleep(SECONDS)
    after, seconds = terminal.cpu(), time.monotonic() - start
    screen, process = ((late - early) / seconds * 100 for early, late in zip(before, after, strict=True))
    return screen, process


def main() -> list[Row]:
    names = [full_name(n, n, FLEETS) for n in range(ROBOTS)]
    with (
        serving("tests.bench.three_fleets_sim", str(ROBOTS)) as (url, _),
        console(url, ROBOTS, kind="rmf", names=names) as terminal,
    ):
        ours = measured(terminal)
    with simulator(ROBOTS) as url, console(url, ROBOTS) as terminal:
        source = measured(terminal)
    what = f"{ROBOTS} robots in three fleets of Open-RMF"
    return times_source("P30", what, ours, source, f"{ROBOTS} of the source's", AT_MOST)


if __name__ == "__main__":
    main()
