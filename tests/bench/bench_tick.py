"""P3: the whole console's tick with 100 robots against the same with 1: CPU of the screen thread.

Run: python -m tests.bench.bench_tick
"""

import asyncio
import os
import statistics
import time
from pathlib import Path
from unittest.mock import patch

import fleet_tui
from fleet_tui.console.app import FleetApp
from fleet_tui.ui.languages import ENGLISH, use_language
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.widgets.runs_view import RunsView
from tests.bench.bench_bytes import CountingDriver
from tests.bench.driven_fleet import TICK, DrivenFleet
from tests.bench.rows import Row, row
from tests.support.in_pty import HEIGHT, WIDTH
from tests.support.terminal import paint

TICKS, WARM, REPEATS = 300, 30, 3
TARGET = 3.0
CLOCK = [0.0]
"""Seconds as the panes have them: ten ticks each, however fast they are made here."""


class Unlinked(FleetApp):
    """The console on a state that is told from here; it ticks when it is told to."""

    CSS_PATH = str(Path(fleet_tui.__file__).parent / "fleet.tcss")

    def _connect(self) -> None: ...


async def tick_ms(robots: int) -> float:
    """Milliseconds of CPU for main.tick and the painting that it causes: mean without the slowest 2 %.

    Where nothing changed for the eye there is no painting: with 1 robot in two ticks of three.
    """
    fleet = DrivenFleet(robots)
    app = Unlinked(fleet.config, fleet.store, load_themes(None)[0], Drawing.BRAILLE)
    app.driver_class = CountingDriver
    spent = []
    async with app.run_test(headless=False, size=(WIDTH, HEIGHT)) as pilot:
        fleet.step()
        await pilot.pause()
        views = list(app.main.query(RunsView))
        for n in range(WARM + TICKS):
            fleet.step()
            CLOCK[0] = n * TICK
            start = time.thread_time()
            app.main.tick()
            # Hidden ones would make Textual arrange all widgets again, as it never does by itself.
            paint(app, *(view for view in views if view.size.height))
            spent.append((time.thread_time() - start) * 1000)
    return statistics.mean(sorted(spent[WARM:])[: -TICKS // 50])


def german_tick_ms(robots: int) -> float:
    """Milliseconds as above, with every text looked up in a catalogue."""
    use_language("de")
    try:
        return asyncio.run(tick_ms(robots))
    finally:
        use_language(ENGLISH)


def main() -> list[Row]:
    clock = patch("fleet_tui.ui.widgets.pace.monotonic", lambda: CLOCK[0])
    with clock, patch.dict(os.environ, TERM="xterm-256color", COLORTERM="truecolor"):
        os.environ.pop("NO_COLOR", None)
        # In turn, and of each the run that was disturbed least.
        runs = [
            (asyncio.run(tick_ms(1)), asyncio.run(tick_ms(100)), german_tick_ms(100)) for _ in range(REPEATS)
        ]
        one, hundred, german = (min(spent) for spent in zip(*runs, strict=True))
    return [
        row("P3", "tick and painting, 100 robots, times that of 1", hundred / one, "x", TARGET),
        row("P3", "tick and painting, 100 robots", hundred, "ms CPU", None, one, "1 robot"),
        row("P3", "the same in German", german, "ms CPU", None, hundred, "in English"),
    ]


if __name__ == "__main__":
    main()
