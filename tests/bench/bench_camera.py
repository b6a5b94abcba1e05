"""P25: the camera of a driving robot, 640 x 480 at 2 fps: bytes to the terminal and CPU, against the same
console without it.

Run: python -m tests.bench.bench_camera
"""

import time

from tests.bench.rows import Row, row
from tests.support.in_pty import Terminal, console, serving

SECONDS = 10.0
KILOBYTES, PROCESS = 60.0, 6.0
DRIVES = ["--fault", "foreign-goal:robot_0"]


def costs(terminal: Terminal) -> tuple[float, float]:
    """Per cent of a core, and kB per second to the terminal."""
    chunks, start, before = len(terminal.chunks), time.monotonic(), terminal.cpu()[1]
    time.sleep(SECONDS)
    seconds = time.monotonic() - start
    size = sum(len(data) for _, data in terminal.chunks[chunks:])
    return (terminal.cpu()[1] - before) / seconds * 100, size / seconds / 1000


def main() -> list[Row]:
    options = [
        "--port",
        "0",
        "--robots",
        "1",
        "--floors",
        "1",
        "--kind",
        "nav2",
        "--stop-with-stdin",
        *DRIVES,
    ]
    with (
        serving("tests.bench.large_camera_sim", *options) as (url, _),
        console(url, 1, kind="nav2") as terminal,
    ):
        terminal.wait_for("in process", 40.0)
        without = costs(terminal)
        terminal.press("V")
        terminal.wait_for("640x480")
        with_it = costs(terminal)
    what, against = "camera 640 x 480 at 2 fps: ", "without the camera"
    return [
        row("P25", what + "added to the process", with_it[0] - without[0], "%", PROCESS, without[0], against),
        row("P25", what + "to the terminal", with_it[1], "kB/s", KILOBYTES, without[1], against),
    ]


if __name__ == "__main__":
    main()
