"""The console on a recording, for tests."""

from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.console.open import replaying
from fleet_tui.records.recording.play.start import playing
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.console_pilot import Console
from tests.support.watched_store import WatchedStore


@asynccontextmanager
async def replayed(
    path: Path, start: str = "", size: tuple[int, int] = (120, 40), notes: Sequence[str] = ()
) -> AsyncIterator[Console]:
    """The console on a recording, stopped."""
    player, config = playing(path, Config(), 1.0, start, lambda _share: None, notes)
    player.toggle()
    store = WatchedStore(player.state)
    app = replaying(config, player, store, load_themes(None)[0], Drawing.BRAILLE)
    async with app.run_test(size=size) as pilot:
        running = Console(app, store, pilot)
        await running.shows("stopped")
        yield running
