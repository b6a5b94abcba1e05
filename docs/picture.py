"""Makes the pictures of the README: the console on the simulated fleet, as `fleet-tui demo` shows it."""

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
ORDER = ["o", *"Base", "enter", *"Consum", "enter"]


async def picture(name: str, size: tuple[int, int], drawing: Drawing, theme: str, keys: list[str]) -> None:
    """Let the robots drive for a while, press some keys, and take the picture."""
    with simulated(robots=3, floors=2) as url:
        config = demo_config(load(shipped()), url, 3, 2)
        store = Store(initial_state(config, time.monotonic()))
        app = FleetApp(config, store, load_themes(None)[0], drawing)
        async with app.run_test(size=size) as pilot:
            app.use_theme(theme)
            await asyncio.sleep(SECONDS)
            await pilot.press(*keys)
            await asyncio.sleep(2)
            path = Path(__file__).parent / f"{name}.svg"
            path.write_text(app.export_screenshot(title="fleet-tui demo"))


async def main() -> None:
    """All of them."""
    await picture("console", (120, 32), Drawing.BRAILLE, "dark", ["e", *ORDER])
    await picture("small", (80, 24), Drawing.BRAILLE, "dark", [*ORDER, "o", *"re"])
    await picture("light", (120, 32), Drawing.HALF_BLOCK, "light", ["t", "P"])


asyncio.run(main())
