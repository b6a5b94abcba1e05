"""Makes the pictures of the README: the console on simulated fleets, as `fleet-tui demo` shows them.

Run: python docs/picture.py [NAME ...]
"""

import asyncio
import sys
import time
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from fleet_tui.app import FleetApp
from fleet_tui.backend import LiveBackend, connect_live
from fleet_tui.config.load import load, shipped
from fleet_tui.config.start import initial_state
from fleet_tui.demo import demo_config, simulated
from fleet_tui.state.store import Store
from fleet_tui.themes import load_themes
from fleet_tui.view.map.drawing import Drawing

SECONDS = 25
ORDER = ["o", *"Base", "enter", *"Consum", "enter"]


@dataclass(frozen=True)
class Picture:
    """A picture: the keys that are pressed before it, and the fleet on it."""

    size: tuple[int, int]
    keys: list[str]
    drawing: Drawing = Drawing.BRAILLE
    theme: str = "dark"
    floors: int = 2
    kind: str = "oh_ressources"
    faults: str = ""


def typed(command: str) -> list[str]:
    """Return the keys of a typed command."""
    names = {" ": "space", ">": "greater_than_sign", "_": "underscore"}
    return ["colon", *(names.get(letter, letter) for letter in command), "enter"]


PICTURES = {
    "console": Picture((120, 32), ["e", *ORDER]),
    "small": Picture((80, 24), [*ORDER, "o", *"re"]),
    "light": Picture((120, 32), ["t", "P"], Drawing.HALF_BLOCK, "light"),
    "nav2": Picture(
        (100, 34),
        [*typed("robot_0 Base > Consumidores"), *typed("robot_0 > Charger"), "e"],
        floors=1,
        kind="nav2",
        faults="foreign-goal:robot_1",
    ),
}


async def take(name: str, picture: Picture) -> None:
    """Let the robots drive for a while, press the keys, and take the picture."""
    fleet = simulated(3, picture.floors, picture.faults, kind=picture.kind)
    with fleet as (url,), TemporaryDirectory() as folder:
        found = load(shipped())
        config = demo_config(found, url, 3, picture.floors, kind=picture.kind, folder=Path(folder))
        store = Store(initial_state(config, time.monotonic()))
        backend = LiveBackend(config, store, partial(connect_live, owner="ana"))
        app = FleetApp(config, store, load_themes(None)[0], picture.drawing, backend=backend)
        async with app.run_test(size=picture.size) as pilot:
            app.use_theme(picture.theme)
            await asyncio.sleep(SECONDS)
            for key in picture.keys:
                await pilot.press(key)
                await asyncio.sleep(0.05)
            await asyncio.sleep(3)
            path = Path(__file__).parent / f"{name}.svg"
            path.write_text(app.export_screenshot(title="fleet-tui demo"))


async def main() -> None:
    """Make the pictures that are named, or all of them."""
    for name in sys.argv[1:] or PICTURES:
        await take(name, PICTURES[name])


asyncio.run(main())
