"""The app before the console, and what it shows."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from textual.pilot import Pilot

from fleet_tui.console.entry import EntryApp
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.ui.themes import load_themes
from tests.support.polling import HANGS
from tests.support.widget_app import screen_rows

PLACES = (("$FLEET_TUI_CONFIG", "not set"), ("./config.toml", "not there"), ("~/c/config.toml", "not there"))
SIZES = [(60, 15), (80, 24), (120, 40)]


class Entry:
    """The app before the console, and what it shows."""

    def __init__(self, app: EntryApp, pilot: Pilot[None]) -> None:
        self.app, self.pilot = app, pilot

    @property
    def text(self) -> str:
        return "\n".join(screen_rows(self.app))

    async def shows(self, *texts: str) -> None:
        """Wait until all this stands there, wherever its lines are broken."""
        await self.until(lambda: all(text in " ".join(self.text.split()) for text in texts), "\n".join(texts))

    async def until(self, holds: Callable[[], bool], what: str) -> None:
        try:
            async with asyncio.timeout(HANGS):
                while not holds():
                    await self.pilot.pause(0.02)
        except TimeoutError:
            raise AssertionError(f"never: {what}\n{self.text}") from None

    async def ended(self) -> None:
        await self.until(lambda: not self.app.is_running, "the end")


@asynccontextmanager
async def entry(
    site: DiscoveredSite | None = None,
    address: str = "",
    size: tuple[int, int] = (80, 24),
    colour: bool = True,
) -> AsyncIterator[Entry]:
    app = EntryApp(load_themes(None)[0]["dark"], colour, site, PLACES, address)
    async with app.run_test(size=size) as pilot:
        yield Entry(app, pilot)
