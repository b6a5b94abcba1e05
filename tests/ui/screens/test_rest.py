"""The first picture comes early, and nothing that is typed before all stands is lost."""

import subprocess
import sys
import time

import pytest

from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.store import Store
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.console_pilot import console
from tests.support.terminal import PlayedDriver, shown, terminal_of
from tests.support.watched_store import config_of


def test_the_first_picture_needs_no_numpy() -> None:
    code = "import sys, fleet_tui.console.open; print({'numpy', 'PIL', 'roslibpy'} & {*sys.modules})"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "set()\n"


@pytest.mark.parametrize(
    ("size", "panes", "robots"), [((120, 40), "Alarms Queue Fleet", 26), ((80, 24), "Queue Fleet", 3)]
)
async def test_the_first_picture_is_the_console_without_its_map(
    size: tuple[int, int], panes: str, robots: int
) -> None:
    config = config_of("ws://127.0.0.1:1", robots=robots)
    app = FleetApp(config, Store(initial_state(config, time.monotonic())), load_themes()[0], Drawing.BRAILLE)
    app.driver_class = PlayedDriver
    seen: list[str] = []

    async def mount_features() -> None:
        seen.extend("".join(cell[0] for cell in row) for row in shown(terminal_of(app)))

    app.main.mount_features = mount_features  # type: ignore[method-assign]  # the rest never comes
    async with app.run_test(headless=False, size=size) as pilot:
        await pilot.pause()
    picture = "\n".join(seen)
    assert [pane for pane in panes.split() if pane not in picture] == []
    assert f"robot_{robots - 1} " in picture, "the panes have their final heights"
    assert "connecting" in picture and "ws://127.0.0.1:1" in picture


async def test_keys_typed_before_anything_is_painted_open_and_fill_the_form(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1), wait=False) as it:
        assert not it.app.main.is_complete
        await it.type("oBase")
        assert it.app.main.features.order_form.is_open
        assert it.app.focused is not None
        await it.shows("Base")
        assert getattr(it.app.focused, "value", None) == "Base"
