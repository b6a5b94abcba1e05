"""Help: what a newcomer sees first, the other pages, and the search in all of them."""

import pytest

from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.console_pilot import Console
from tests.support.planted_console import SITE, planted

TASKS = ("Send an order", "Stop a robot", "See what is wrong", "Look around on the map", "Look back in time")


def shown(it: Console) -> str:
    """The text of the open help."""
    return it.pane("help-text")


@pytest.mark.parametrize("size", [(120, 40), (200, 60), (100, 30)])
async def test_it_opens_on_all_tasks_at_once(size: tuple[int, int]) -> None:
    async with planted(1, 1, size) as it:
        await it.press("?")
        await it.shows("Send an order", "help-text")
        assert [task for task in TASKS if task not in shown(it)] == []
        assert "P F12" in shown(it) and "robot_1" not in shown(it)


async def test_at_80_by_24_the_tasks_are_three_screens() -> None:
    async with planted(1, 1, (80, 24)) as it:
        await it.press("?")
        await it.shows("Send an order", "help-text")
        assert "Stop a robot" in shown(it) and "Choose a robot or a floor" in shown(it)
        await it.press("pagedown")
        await it.hides("Send an order")
        assert "Look around on the map" in shown(it)
        await it.press("pagedown")
        await it.shows("Quit", "help-text")
        last = shown(it)
        await it.press("pagedown")
        assert shown(it) == last
        await it.press("up")
        assert shown(it).splitlines()[1:] == last.splitlines()[:-1]


async def test_tab_and_clicks_turn_the_pages() -> None:
    async with planted() as it:
        await it.press("?", "tab")
        await it.shows("Zoom in", "help-text")
        await it.press("tab")
        await it.shows("a docking station", "help-text")
        await it.press("shift+tab", "shift+tab")
        await it.shows("Stop a robot", "help-text")
        await it.pilot.click("#help-pages", offset=(it.pane("help-pages").index("Commands"), 0))
        await it.shows("robot_0 Base > Store", "help-text")
        assert SITE in it.text
        await it.press("escape")
        await it.hides("robot_0 Base > Store")
        await it.press("?")
        await it.shows("Stop a robot", "help-text")


async def test_typing_searches_tasks_keys_and_legend() -> None:
    async with planted() as it:
        await it.press("?")
        await it.type("pause all")
        await it.shows("Pause all robots immediately", "help-text")
        assert "P F12" in shown(it) and "Zoom in" not in shown(it)
        await it.press("tab", "?")
        assert "a docking station" not in shown(it)
        await it.press("backspace")
        await it.type("legend")
        await it.shows("a docking station", "help-text")
        assert "⌂ Dock" in shown(it) and "Pause" not in shown(it)
        await it.type("zzz")
        await it.shows("nothing matches 'legendzzz'", "help-text")
        assert "Try a shorter or another word" in shown(it)


async def test_words_that_people_bring_find_keys_of_other_words() -> None:
    async with planted() as it:
        for typed, found in (
            ("stuck", "Explain why"),
            ("deliver", "Open the order form"),
            ("emergency", "Pause all robots"),
            ("exit", "Quit"),
            ("theme", "Open the command palette"),
            ("offline", "Open diagnostics"),
            ("save", "save config.toml"),
            ("prometheus", "fleet-tui docs metrics"),
        ):
            await it.press("?")
            await it.type(typed)
            await it.shows(found, "help-text")
            await it.press("escape")


async def test_the_legend_is_drawn_as_the_map() -> None:
    async with planted() as it:
        await it.press("m", "m")
        assert it.app.main.features.map.picture.options.drawing is Drawing.ASCII
        await it.press("?")
        await it.type("docking station")
        await it.shows("D.Dock", "help-text")


async def test_it_follows_the_size_of_the_terminal() -> None:
    async with planted() as it:
        await it.press("?")
        await it.shows("Look back in time", "help-text")
        await it.pilot.resize_terminal(80, 24)
        await it.hides("Look back in time")
        await it.shows("Send an order", "help-text")


async def test_the_keys_in_the_maps_title_lead_to_the_legend() -> None:
    async with planted(1, 1, (160, 40)) as it:
        await it.shows("? Tab Tab legend", "map")
        await it.press("question_mark", "tab", "tab")
        await it.shows("[Legend]")
