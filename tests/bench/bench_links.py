"""500 robots over three bridges (pose 5 Hz, the rest 1 Hz): does the console stay usable?

Run: python -m tests.bench.bench_links
"""

import statistics
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path

from tests.bench.in_pty import Terminal, serving
from tests.bench.rows import Row, p95, row

FLEETS = (167, 167, 166)
SETTLE, SECONDS, KEYS = 10.0, 20.0, 60
EVERY = ["sim", "--port", "0", "--stop-with-stdin", "--floors", "1", "--rate", "5"]


def config(folder: Path, urls: list[str]) -> Path:
    """Three links, and every robot on its own."""
    text = f'[rosbridge]\nurl = "{urls[0]}"\n'
    text += "".join(f'[links.site_{n}]\nurl = "{url}"\n' for n, url in enumerate(urls[1:], 1))
    text += '[[floors]]\nname = "floor_0"\n[ui]\npose_ms = 200\nstatus_ms = 1000\n'
    first = 0
    for n, count in enumerate(FLEETS):
        link = f'link = "site_{n}"\n' if n else ""
        text += "".join(f'[[robots]]\nname = "robot_{first + i}"\n{link}' for i in range(count))
        first += count
    path = folder / "config.toml"
    path.write_text(text)
    return path


def measured(terminal: Terminal) -> tuple[float, float, float, list[float]]:
    """Per cent of a core: screen thread and process; MB; milliseconds until something answers a key."""
    time.sleep(SETTLE)
    before, start, answers = terminal.cpu(), time.monotonic(), []
    for n in range(KEYS):
        chunks, pressed = len(terminal.chunks), terminal.press("+-"[n % 2])
        while len(terminal.chunks) == chunks and time.monotonic() - pressed < 2.0:
            time.sleep(0.0005)
        answers.append((terminal.chunks[-1][0] - pressed) * 1000)
        time.sleep(SECONDS / KEYS)
    seconds, after = time.monotonic() - start, terminal.cpu()
    screen, process = ((late - early) / seconds * 100 for early, late in zip(before, after, strict=True))
    return screen, process, terminal.megabytes(), answers


def main() -> list[Row]:
    with tempfile.TemporaryDirectory() as name, ExitStack() as stack:
        urls, first = [], 0
        for count in FLEETS:
            counts = ["--robots", str(count), "--first", str(first)]
            urls.append(stack.enter_context(serving("fleet_tui", *EVERY, *counts))[0])
            first += count
        command = ["fleet_tui", "--config", str(config(Path(name), urls))]
        terminal = Terminal([sys.executable, "-m", *command], Path(name))
        try:
            terminal.wait_for(f"{first} of {first} online", 60.0)
            screen, process, megabytes, answers = measured(terminal)
        finally:
            terminal.close()
    what = f"{first} robots over 3 links: "
    return [
        row("L12", what + "screen thread", screen, "%"),
        row("L12", what + "process", process, "%"),
        row("L12", what + "memory", megabytes, "MB"),
        row("L12", what + "key -> answer, median", statistics.median(answers), "ms"),
        row("L12", what + "key -> answer, p95", p95(answers), "ms"),
    ]


if __name__ == "__main__":
    main()
