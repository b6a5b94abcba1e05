"""P18: `fleet-tui URL`, from the start of its process to the robots on the screen, against `status --url`
in one run; and the discovery of a hundred robots.

Run: python -m tests.bench.bench_arrival
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from fleet_tui.simulator.kinds import KINDS
from tests.bench.rows import Row, row
from tests.support.in_pty import Terminal, simulator

STARTS = 7
MANY = 100
RATIO, ON_SCREEN, MANY_WITHIN = 2.0, 3.0, 10.0


def status(url: str, folder: Path) -> float:
    """Seconds until `status --url` has ended."""
    began = time.monotonic()
    command = [sys.executable, "-m", "fleet_tui", "status", "--url", url]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, check=True)
    if b"robot_0" not in done.stdout:
        raise AssertionError(done.stdout)
    return time.monotonic() - began


def on_screen(url: str, folder: Path) -> float:
    """Seconds until the console shows all robots online."""
    terminal = Terminal([sys.executable, "-m", "fleet_tui", url], folder)
    try:
        return _robots_seen(terminal)
    finally:
        terminal.close()


def _robots_seen(terminal: Terminal) -> float:
    while "3 of 3 online" not in terminal.text():
        if time.monotonic() - terminal.started > 20.0:
            raise TimeoutError(terminal.text())
        time.sleep(0.005)
    return terminal.chunks[-1][0] - terminal.started


def discovery(kind: str, folder: Path) -> float:
    """Seconds of a whole `config init --from-live` of many robots."""
    with simulator(MANY, kind=kind) as url:
        began = time.monotonic()
        command = [sys.executable, "-m", "fleet_tui", "config", "init", "--from-live", url]
        done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, check=True)
        if done.stdout.count(b"[[robots]]") != MANY:
            raise AssertionError(done.stdout)
        return time.monotonic() - began


def main() -> list[Row]:
    rows = list[Row]()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for kind in KINDS:
            with simulator(3, kind=kind) as url:
                pairs = [(status(url, folder), on_screen(url, folder)) for _ in range(STARTS)]
            told, seen = (statistics.median(one) for one in zip(*pairs, strict=True))
            what, against = (
                f"fleet-tui URL, 3 robots ({kind}): start -> robots seen",
                "status --url: start -> end",
            )
            rows += [
                row("P18", what, seen, "s", ON_SCREEN, told, against),
                row("P18", f"{what}, times status --url", seen / told, "x", RATIO),
                row("P18", f"discovery of {MANY} robots ({kind})", discovery(kind, folder), "s", MANY_WITHIN),
            ]
    return rows


if __name__ == "__main__":
    main()
