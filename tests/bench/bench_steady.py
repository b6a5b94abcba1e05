"""P5: the console with 100 robots at work, as a real process in a pty, against stock Textual's painting.

1,800 messages a second: the simulator tells every pose 10 times a second and four topics twice.
Run: python -m tests.bench.bench_steady
"""

import os
import time

from tests.bench.rows import Row, row
from tests.support.in_pty import console, simulator

ROBOTS = 100
SETTLE, SECONDS = 6.0, 24.0
SCREEN, PROCESS, KILOBYTES = 5.0, 12.0, 60.0


def steady(probe: list[str] | None) -> tuple[float, float, float]:
    """Per cent of a core: screen thread and process; kB per second to the terminal."""
    with simulator(ROBOTS) as url, console(url, ROBOTS, probe) as terminal:
        terminal.wait_for(f"{ROBOTS} of {ROBOTS} online")
        time.sleep(SETTLE)
        chunks, start = len(terminal.chunks), time.monotonic()
        before = terminal.cpu()
        time.sleep(SECONDS)
        after = terminal.cpu()
        seconds = time.monotonic() - start
        size = sum(len(data) for _, data in terminal.chunks[chunks:])
    screen, process = ((late - early) / seconds * 100 for early, late in zip(before, after, strict=True))
    return screen, process, size / seconds / 1000


def main() -> list[Row]:
    ours = steady(None)
    stock = steady([os.devnull, "stock"])
    against = "stock Textual painting"
    what = f"{ROBOTS} robots steady, 1,800 msg/s: "
    return [
        row("P5", what + "screen thread", ours[0], "%", SCREEN, stock[0], against),
        row("P5", what + "process", ours[1], "%", PROCESS, stock[1], against),
        row("P5", what + "to the terminal", ours[2], "kB/s", KILOBYTES, stock[2], against),
    ]


if __name__ == "__main__":
    main()
