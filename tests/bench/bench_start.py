"""P10: from the start to the first paint, and the memory in steady state, against a trivial Textual app.

Run: python -m tests.bench.bench_start
"""

import statistics
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from PIL import Image

from tests.bench.rows import Row, row
from tests.support.in_pty import Terminal, console, shows_racks, simulator

STARTS = 9
SIDE = 4000
STEADY = 15.0  # seconds
RATIO, RSS = 2.0, 110.0


def trivial(folder: Path) -> tuple[float, float]:
    """Seconds to the first paint, MB."""
    terminal = Terminal([sys.executable, "-m", "tests.bench.trivial_app"], folder)
    try:
        seconds = terminal.first_seen(b"hello")
        time.sleep(0.5)
        return seconds, terminal.megabytes()
    finally:
        terminal.close()


def first_paint(url: str) -> float:
    """Seconds until the console's panes stand, titles and all."""
    with console(url, 3) as terminal:
        return terminal.first_seen(b"Fleet")


def map_file(folder: Path) -> Path:
    """A hall of racks as map_server keeps it."""
    cells = np.full((SIDE, SIDE), 254, np.uint8)
    cells[:20] = cells[-20:] = cells[:, :20] = cells[:, -20:] = 0
    for y in range(200, SIDE - 200, 200):
        cells[y : y + 60, 300:-300] = 0
    Image.fromarray(cells).save(folder / "hall.pgm")
    yaml = "image: hall.pgm\nresolution: 0.05\norigin: [-20.0, -20.0, 0.0]\nnegate: 0\n"
    (folder / "hall.yaml").write_text(yaml + "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
    return folder / "hall.yaml"


def memory(url: str, folder: Path) -> float:
    """MB with the map from a file, zoomed and panned about in, in steady state."""
    with console(url, 3, floor_map=map_file(folder)) as terminal:
        terminal.wait_for("3 of 3 online")
        for key in "+++hhhkkkm---mm0":
            terminal.press(key)
            time.sleep(0.2)
        time.sleep(STEADY)
        if not shows_racks(terminal):
            raise AssertionError(f"the map is not shown\n{terminal.text()}")
        return terminal.megabytes()


def main() -> list[Row]:
    with tempfile.TemporaryDirectory() as name, simulator(3) as url:
        folder = Path(name)
        plain, ours = [], []
        for _ in range(STARTS):
            plain.append(trivial(folder))
            ours.append(first_paint(url))
        least = statistics.median(seconds for seconds, _ in plain)
        painted = statistics.median(ours)
        megabytes = memory(url, folder)
    what = "start -> first paint"
    return [
        row("P10", f"{what}, times that of a trivial Textual app", painted / least, "x", RATIO),
        row("P10", what, painted * 1000, "ms", None, least * 1000, "trivial Textual app"),
        row(
            "P10",
            f"memory with a {SIDE} x {SIDE} map file, steady",
            megabytes,
            "MB",
            RSS,
            statistics.median(megabytes for _, megabytes in plain),
            "trivial Textual app",
        ),
    ]


if __name__ == "__main__":
    main()
