"""The simple interface comes above the map, beside it or in its place, and goes."""

import pytest
from textual.app import ComposeResult

from fleet_tui.ui.screens.simple import Simple
from tests.support.planted_console import planted


@pytest.mark.parametrize(("size", "has_map"), [((80, 24), True), ((60, 24), False), ((120, 40), True)])
async def test_it_comes_and_goes_and_pausing_works_within(size: tuple[int, int], has_map: bool) -> None:
    async with planted(2, 1, size) as it:
        await it.press("s")
        await it.shows("From: choose")
        assert (it.app.main.features.map.region.height > 0) is has_map
        await it.press("enter")
        await it.shows("From where?")
        await it.press("f12")
        await it.until(lambda state: all(state.is_paused(robot) for robot in state.robots.values()))
        await it.press("escape")
        await it.shows("From: choose")
        await it.press("s")
        await it.shows_a_label()
        assert it.app.main.focused is it.app.main.features.map
        await it.press("s")
        await it.shows("Esc: back to the map")
        await it.press("escape")
        await it.shows_a_label()
        assert it.app.main.focused is it.app.main.features.map


async def test_a_tick_while_it_is_being_made(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Simple.compose
    async with planted(2, 1, (120, 40)) as it:

        def compose(simple: Simple) -> ComposeResult:
            it.app.main.tick()
            yield from made(simple)

        monkeypatch.setattr(Simple, "compose", compose)
        await it.press("s")
        await it.shows("Robot: robot_0")


async def test_a_tick_while_its_widgets_go() -> None:
    """As when the console ends on a busy machine: one after the other."""
    async with planted(2) as it:
        await it.press("s")
        await it.shows("From: choose")
        await it.app.main.query_one("#simple-robot").remove()
        await it.press(".")
        it.app.main.features.simple.show()
