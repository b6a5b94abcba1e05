"""P29: the console with 200 vehicles of VDA 5050 against 100 robots of the source, in one run.

1,200 messages a second over a real mosquitto: a state each second and five visualizations.
Run: python -m tests.bench.bench_vehicles
"""

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from fleet_tui.cli.session import opened
from fleet_tui.config.load import from_text
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.state.store import Store
from tests.bench.bench_steady import steady
from tests.bench.rows import Row, row, times_source
from tests.support.broker import PROGRAM, broker_in
from tests.support.in_pty import Terminal

VEHICLES, PER_SECOND = 200, 1200
SETTLE, SECONDS, COUNTED = 6.0, 20.0, 10.0
AT_MOST = 1.2
"""Times what 100 of the source's robots cost."""


def config_of(url: str) -> str:
    robots = "".join(
        f'[[robots]]\nname = "robot_{n}"\nmanufacturer = "KIT"\nserial = "{n}"\nlink = "broker"\n'
        for n in range(VEHICLES)
    )
    return f'[links.broker]\nurl = "{url}"\n[[floors]]\nname = "floor_0"\n{robots}'


@contextmanager
def traffic(folder: Path) -> Iterator[str]:
    """The address of a broker with all vehicles on it."""
    with broker_in(folder) as broker:
        command = [sys.executable, "-m", "tests.bench.vehicle_traffic", str(broker.port), str(VEHICLES)]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        try:
            yield broker.url
        finally:
            process.kill()
            process.wait()


def busy() -> tuple[float, float]:
    """Per cent of a core: screen thread and process."""
    with tempfile.TemporaryDirectory() as name, traffic(Path(name)) as url:
        config = Path(name) / "config.toml"
        config.write_text(config_of(url))
        terminal = Terminal([sys.executable, "-m", "fleet_tui", "--config", str(config)], Path(name))
        try:
            terminal.wait_for(f"{VEHICLES} of {VEHICLES} online")
            time.sleep(SETTLE)
            start, before = time.monotonic(), terminal.cpu()
            time.sleep(SECONDS)
            after, seconds = terminal.cpu(), time.monotonic() - start
        finally:
            terminal.close()
    screen, process = ((late - early) / seconds * 100 for early, late in zip(before, after, strict=True))
    return screen, process


def carried() -> float:
    """The messages a second that a link without a screen reads."""
    with tempfile.TemporaryDirectory() as name, traffic(Path(name)) as url:
        config = from_text(config_of(url))
        store = Store(initial_state(config, time.monotonic()))
        with opened(FleetLink(config, store), config) as link:
            time.sleep(SETTLE)
            counter, start = link.counters["broker"], time.monotonic()
            before = counter.all.count
            time.sleep(COUNTED)
            return (counter.all.count - before) / (time.monotonic() - start)


def main() -> list[Row]:
    if PROGRAM is None:
        print("mosquitto is not installed: vehicles are not measured")
        return []
    ours, (screen, process, _) = busy(), steady(None)
    what = f"{VEHICLES} vehicles, {PER_SECOND} msg/s"
    return [
        *times_source("P29", what, ours, (screen, process), "100 of the source's", AT_MOST),
        row("P29", f"{what}: read of those sent", carried() / PER_SECOND * 100, "%"),
    ]


if __name__ == "__main__":
    main()
