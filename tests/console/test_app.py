"""Without colour no screen sends any, and what is marked still stands out."""

import math
import re
import time
from collections.abc import AsyncIterator

import pytest
from textual.pilot import Pilot

from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp, clock
from fleet_tui.state.store import Store
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.polling import until
from tests.support.terminal import PlayedDriver, shown, terminal_of
from tests.support.watched_store import config_of


@pytest.fixture
async def pilot(monkeypatch: pytest.MonkeyPatch) -> AsyncIterator[Pilot[None]]:
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("COLORTERM", "truecolor")
    config = config_of("ws://127.0.0.1:1", robots=3)
    store = Store(initial_state(config, time.monotonic()))
    app = FleetApp(config, store, load_themes()[0], Drawing.BRAILLE, colour=False)
    app.driver_class = PlayedDriver
    async with app.run_test(headless=False, size=(120, 40)) as running:
        await running.pause()
        yield running


def marked(pilot: Pilot[None], by: str) -> list[str]:
    """The runs in reverse or underlined."""
    found = []
    for row in shown(terminal_of(pilot.app)):
        looks = [{"reverse": reverse, "underline": underline} for *_, reverse, underline in row]
        line = "".join(cell[0] if look[by] else "\n" for cell, look in zip(row, looks, strict=True))
        found += [part.rstrip() for part in line.split("\n") if part]
    return found


async def test_no_screen_sends_a_colour(pilot: Pilot[None]) -> None:
    for keys in (["?", "a"], ["o", "B"], [":", "z"], ["X"], ["x"], ["tab", "enter"], ["g"], ["m"], ["m"]):
        await pilot.press(*keys)
        await pilot.press("escape")
    await pilot.resize_terminal(70, 20)
    await pilot.pause()
    sent = "".join(terminal_of(pilot.app).written)
    codes = {code for part in re.findall(r"\x1b\[([0-9;:]*)m", sent) for code in re.split("[;:]", part)}
    assert codes <= {"", "0", "1", "2", "3", "4", "7", "9"}


async def test_what_is_marked_stands_out(pilot: Pilot[None]) -> None:
    await pilot.press(":", *"next")
    await pilot.pause()
    assert [line.split() for line in marked(pilot, "underline")] == [["Next", "robot", "."]]
    await until(lambda: "" in marked(pilot, "reverse"))  # the cursor after what was typed; it blinks
    await pilot.press("escape", "o", *"robot")
    await until(lambda: "" in marked(pilot, "reverse"))


@pytest.mark.parametrize(
    ("wall", "text"), [(0.0, ""), (1e308, "no time"), (math.inf, "no time"), (math.nan, "no time")]
)
def test_a_time_that_no_clock_has_is_said_to_be_none(wall: float, text: str) -> None:
    assert clock(wall) == text
    assert re.fullmatch(r"\d\d:\d\d:\d\d", clock(1.7e9))
