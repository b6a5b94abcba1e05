"""500 robots over three bridges (pose 5 Hz, the rest 1 Hz): is the console usable, does it take all in?

Run: python -m tests.bench.bench_links
"""

import json
import statistics
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path

from tests.bench.rows import Row, p95, row
from tests.support.in_pty import Terminal, serving

FLEETS = (167, 167, 166)
SETTLE, SECONDS, KEYS = 10.0, 20.0, 60
EVERY = ["--port", "0", "--stop-with-stdin", "--floors", "1", "--rate", "5"]


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


def stopped(servers: list[subprocess.Popen[bytes]], files: list[Path]) -> int:
    """How many messages the servers have sent, all of them on their way by now."""
    for server in servers:
        assert server.stdin is not None
        server.stdin.close()
    for server in servers:
        server.wait(20)
    return sum(int(file.read_text()) for file in files)


def main() -> list[Row]:
    with tempfile.TemporaryDirectory() as name, ExitStack() as stack:
        urls, servers, first = [], [], 0
        files = [Path(name) / f"sent_{n}" for n in range(len(FLEETS))]
        for count, file in zip(FLEETS, files, strict=True):
            arguments = [str(file), *EVERY, "--robots", str(count), "--first", str(first)]
            url, server = stack.enter_context(serving("tests.bench.counting_sim", *arguments))
            urls.append(url)
            servers.append(server)
            first += count
        received = Path(name) / "heard.json"
        command = [
            "tests.bench.probe",
            str(received),
            "counts",
            "--",
            "--config",
            str(config(Path(name), urls)),
        ]
        terminal = Terminal([sys.executable, "-m", *command], Path(name))
        try:
            terminal.wait_for(f"{first} of {first} online", 60.0)
            screen, process, megabytes, answers = measured(terminal)
            sent = stopped(servers, files)
            terminal.wait_for(f"0 of {first} online", 60.0)
        finally:
            terminal.close()
        (applied, passed_over), *_ = json.loads(received.read_text())["count"]
    what = f"{first} robots over 3 links: "
    return [
        row("L12", what + "messages sent", sent, "messages"),
        row("L12", what + "messages not applied", sent - applied + passed_over, "messages", 0),
        row("L12", what + "screen thread", screen, "%"),
        row("L12", what + "process", process, "%"),
        row("L12", what + "memory", megabytes, "MB"),
        row("L12", what + "key -> answer, median", statistics.median(answers), "ms"),
        row("L12", what + "key -> answer, p95", p95(answers), "ms"),
    ]


if __name__ == "__main__":
    main()
