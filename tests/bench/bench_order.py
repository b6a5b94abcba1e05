"""P7: from Enter in the order form to the service call on the wire, with 1 and with 100 robots."""

import asyncio
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from textual import events

from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.console.demo import demo_config, simulated
from fleet_tui.model.commands import PauseRobot
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.bench.rows import Row, p95, row
from tests.bench.wiretap import wiretap
from tests.support.console_pilot import Console
from tests.support.watched_store import WatchedStore

ORDERS = 60
# The same order given again within a second is not sent.
STARTS = ["Base", "Receiving"]
ENDS = ["Consumidores", "Store", "Packing", "Dispatch", "Charger", "Lift"]
TRIPS = [(start, end) for start in STARTS for end in ENDS]
TARGETS = {1: 5.0, 100: 15.0}


def calls(service: str) -> Callable[[dict[str, Any]], bool]:
    """Return a test for calls to a service: its name alone is also in the questions to rosapi."""
    return lambda frame: frame.get("service", "").endswith(service)


def key(app: FleetApp, name: str) -> None:
    app.post_message(events.Key(name, name if len(name) == 1 else None))


async def orders(it: Console) -> list[float]:
    """Milliseconds from Enter to the wire, per order."""
    sent: list[float] = []
    taken = []
    with wiretap(calls("Execute_order"), sent):
        for n in range(ORDERS):
            start, end = TRIPS[n % len(TRIPS)]
            for name in ["o", *start, "enter", *end]:
                key(it.app, name)
            # Let the typing settle: the measure is Enter alone, at any moment of the tick.
            await asyncio.sleep(0.4 + n % 10 * 0.011)
            started = time.perf_counter()
            key(it.app, "enter")
            await it.until(lambda _, n=n: len(sent) > n)  # type: ignore[misc]  # bound now
            taken.append((sent[-1] - started) * 1000)
    return taken


async def direct(it: Console) -> list[float]:
    """The same way without the screen: submit to wire."""
    sent: list[float] = []
    taken = []
    with wiretap(calls("Pause"), sent):
        for n in range(ORDERS):
            started = time.perf_counter()
            it.app.backend.submit(PauseRobot("robot_0"))
            await it.until(lambda _, n=n: len(sent) > n)  # type: ignore[misc]  # bound now
            taken.append((sent[-1] - started) * 1000)
    return taken


async def measure(robots: int) -> Row:
    with simulated(robots, 2) as (url,):
        config = demo_config(Config(path=Path("bench")), url, robots, 2)
        store = WatchedStore(initial_state(config, time.monotonic()))
        app = FleetApp(config, store, load_themes(None)[0], Drawing.BRAILLE)
        async with app.run_test(size=(200, 60)) as pilot:
            it = Console(app, store, pilot)
            await it.until(lambda state: all(robot.queue for robot in state.robots.values()))
            await it.shows("Base", "map")
            screen, bare = await orders(it), await direct(it)
    what = f"Enter -> call on the wire, {robots} robot{'s' * (robots > 1)}, p95"
    return row("P7", what, p95(screen), "ms", TARGETS[robots], p95(bare), "submit -> wire, no screen")


def main() -> list[Row]:
    return [asyncio.run(measure(robots)) for robots in TARGETS]


if __name__ == "__main__":
    main()
