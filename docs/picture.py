"""Makes docs/console.svg: the console on the simulated fleet, as `fleet-tui demo` shows it."""

import asyncio
import time
from pathlib import Path

from fleet_tui.app import FleetApp
from fleet_tui.config.load import load, shipped
from fleet_tui.config.start import initial_state
from fleet_tui.demo import demo_config, simulated
from fleet_tui.store import Store
from fleet_tui.themes import load_themes
from fleet_tui.view.raster import Drawing

SECONDS = 25


async def main() -> None:
    """Let the robots drive for a while, give one an order, and take the picture."""
    with simulated(robots=3, floors=2) as url:
        config = demo_config(load(shipped()), url, 3, 2)
        store = Store(initial_state(config, time.monotonic()))
        app = FleetApp(config, store, load_themes(None)[0], Drawing.BRAILLE)
        async with app.run_test(size=(120, 32)) as pilot:
            await asyncio.sleep(SECONDS)
            await pilot.press("e", "o", *"Base", "enter", *"Consum", "enter")
            await asyncio.sleep(2)
            (Path(__file__).parent / "console.svg").write_text(app.export_screenshot(title="fleet-tui demo"))


asyncio.run(main())
