"""P27: a month of a hundred robots: the history's pages, and the report with its start.

Run: python -m tests.bench.bench_history
"""

import os
import random
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import closing
from pathlib import Path

from fleet_tui.config.load import load
from fleet_tui.features.history.controls import PAGES, read_page
from fleet_tui.records.history.database import history_path, open_to_write, transaction
from fleet_tui.records.history.division import divided
from fleet_tui.records.history.observing import HOUR
from tests.bench.rows import Row, row
from tests.support.routine_files import ONE_ROBOT

DAYS, ROBOTS = 30, 100
PLACES = ("Base", "Store", "Dock", "Dispatch", "Kitchen", "Archive", "Workshop", "Laundry")
CYCLE = 600.0
"""Seconds of an order with what comes before and after it."""
REPEATS = 3

Values = tuple[object, ...]


def fill(path: Path, now: float) -> None:
    """Write a month in the tables' own form: 400,000 orders, 2.6 million spans, 4.3 million levels."""
    database, _ = open_to_write(path)
    begun = now - DAYS * 24 * HOUR
    rng = random.Random(1)
    with closing(database):
        database.execute("PRAGMA synchronous = OFF")
        for number in range(ROBOTS):
            robot = f"robot_{number}"
            with transaction(database):
                for table, columns, values in _of_robot(robot, begun, now, rng):
                    places = ", ".join("?" * (columns.count(",") + 1))
                    database.executemany(f"INSERT INTO {table} ({columns}) VALUES ({places})", values)


def _of_robot(
    robot: str, begun: float, now: float, rng: random.Random
) -> Iterator[tuple[str, str, Sequence[Values]]]:
    cycles = [begun + n * CYCLE for n in range(int((now - begun) / CYCLE))]
    yield (
        "orders",
        "robot, name, way, floor, queued, begun, ended, stage, reason, operator, run",
        [
            (robot, str(n), f"{rng.choice(PLACES)} -> {rng.choice(PLACES)}", "f", at, at + 30, at + 300, *end)
            for n, at in enumerate(cycles)
            for end in [("lost", "gone", "", "r") if n % 50 == 0 else ("done", "", "", "r")]
        ],
    )
    spans = [("waiting", 0, 30), ("driving", 30, 200), ("blocked", 200, 230), ("driving", 230, 300)]
    spans += [("loading", 300, 360), ("idle", 360, 600)]
    yield (
        "spans",
        "robot, began, ended, activity, floor, x, y",
        [
            (robot, at + first, at + last, does, "f", rng.gauss(10, 3), rng.gauss(10, 3))
            for at in cycles
            for does, first, last in spans
        ],
    )
    hours = range(int(begun // HOUR), int(now // HOUR) + 1)
    shares = (
        ("driving", 1440.0),
        ("idle", 1440.0),
        ("blocked", 180.0),
        ("loading", 360.0),
        ("waiting", 180.0),
    )
    yield (
        "hours",
        "robot, hour, activity, seconds",
        [(robot, hour, *share) for hour in hours for share in shares],
    )
    minutes = int((now - begun) / 60)
    levels = [(robot, begun + 60.0 * n, 30.0 + n % 60) for n in range(minutes)]
    yield "charges", "robot, at, percent", levels
    yield "charge_hours", "robot, hour, low, last", [(robot, hour, 30.0, 60.0) for hour in hours]
    alarms = [
        (f"r{n}", robot, "obstacle", "high", "x", at, at + 90, at + 90, "", 1)
        for n, at in enumerate(cycles[::12])
    ]
    yield "alarms", "run, source, kind, priority, text, raised, returned, ended, operator, count", alarms


def seconds_of(*command: str, folder: Path) -> float:
    """Return the seconds of the fastest of some runs of a command."""
    environment = {**os.environ, "XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder)}
    times = []
    for _ in range(REPEATS):
        begun = time.perf_counter()
        subprocess.run(
            [sys.executable, "-m", "fleet_tui", *command],
            cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL,
        )  # fmt: skip
        times.append(time.perf_counter() - begun)
    return min(times)


def main() -> list[Row]:
    with tempfile.TemporaryDirectory() as name:
        folder, now = Path(name), time.time()
        (folder / "config.toml").write_text(ONE_ROBOT)
        path = history_path(folder / "fleet-tui", load(folder / "config.toml"))
        fill(path, now)
        month = divided(now - DAYS * 24 * HOUR, now, 80)
        pages = {}
        for page in PAGES:
            times = []
            for _ in range(REPEATS):
                begun = time.perf_counter()
                read_page(path, page, month, 20.0)
                times.append(time.perf_counter() - begun)
            pages[page] = min(times) * 1000
        start = seconds_of("check", folder=folder)
        report = seconds_of("report", "--since", "30d", "--output", "m.html", folder=folder)
        size = (folder / "m.html").stat().st_size / 1e6
    others = max(pages, key=lambda one: pages[one])
    return [
        row("P27", "H opens a month of 100 robots", pages["Events"], "ms", 200.0),
        row("P27", f"its slowest page ({others})", pages[others], "ms"),
        row("P27", "report of that month", report, "s", 3.0, start, "fleet-tui check"),
        row("P27", "its size", size, "MB", 2.0),
    ]


if __name__ == "__main__":
    main()
