"""A filter typed over a table, from the first key to the last."""

from types import SimpleNamespace

import pytest

from fleet_tui.ui.screens.tables import tools
from fleet_tui.ui.screens.tables.tools import ALL_EVERY
from fleet_tui.ui.widgets import pace
from tests.support.console_pilot import Console
from tests.support.planted_console import planted


def rows(it: Console) -> list[str]:
    return [line for line in it.pane("fleet").splitlines()[1:] if "robot_" in line]


async def test_the_table_follows_each_letter_and_enter_goes_to_what_it_found() -> None:
    async with planted(12) as it:
        await it.press("/")
        await it.shows(" Fleet /")
        await it.type("1")
        assert len(rows(it)) == 3, "robot_1, robot_10, robot_11"
        await it.type("1")
        assert len(rows(it)) == 1 and "/11: 1" in it.text
        await it.press("enter")
        await it.until(lambda _: it.app.main.navigation.robot == "robot_11")
        assert it.app.main.focused is it.app.main.fleet and len(rows(it)) == 1
        await it.press("escape")
        assert len(rows(it)) == 12 and it.app.main.navigation.robot == "robot_11"


async def test_typed_and_entered_in_one_packet_it_goes_to_the_exact_number() -> None:
    async with planted(12) as it:
        for key in ("/", "1", "enter"):
            it.send(key)
        await it.until(lambda _: it.app.main.navigation.robot == "robot_1")


async def test_escape_clears_it_and_returns_to_where_one_was() -> None:
    async with planted(3) as it:
        await it.press("/")
        await it.type("nobody")
        await it.shows("nothing matches the filter")
        await it.press("escape")
        assert len(rows(it)) == 3 and it.app.main.focused is it.app.main.features.map


async def test_the_focused_table_is_filtered() -> None:
    async with planted(2) as it:
        await it.press("tab", "tab", "tab", "/")
        await it.shows(" Queue /")
        await it.type("x")
        assert it.app.main.queue.arrangement.typed == "x" and it.app.main.fleet.arrangement.typed == ""


async def test_nothing_is_prepared_once_it_is_left() -> None:
    async with planted(3) as it:
        for key in ("enter", "escape"):
            await it.press("/")
            assert it.app.main.fleet.arrangement.is_typing
            await it.press("1", key)
            assert not it.app.main.fleet.arrangement.is_typing


async def test_a_filter_that_found_nobody_leaves_the_cursor_on_the_selected_robot() -> None:
    async with planted(3) as it:
        await it.press("tab", "down", "down")
        assert it.app.main.navigation.robot == "robot_2"
        for keys in (("enter", "escape"), ("escape",)):
            await it.press("/")
            await it.type("zzz")
            await it.press(*keys)
            assert it.app.main.fleet.listing.cursor == it.app.main.navigation.robot == "robot_2"


async def test_a_tick_waits_for_a_letter_but_not_for_long(monkeypatch: pytest.MonkeyPatch) -> None:
    async with planted(3) as it:
        line = it.app.main.features.tables.filter_line
        assert not line.goes_first
        typed_at = 100.0
        monkeypatch.setattr(tools, "time", SimpleNamespace(monotonic=lambda: typed_at))
        await it.press("/")
        await it.type("1")
        goes_first = []
        for seconds in (0.1, 0.2, 0.25, 0.31, 0.4):
            monkeypatch.setattr(tools, "time", SimpleNamespace(monotonic=lambda s=seconds: typed_at + s))
            monkeypatch.setattr(pace, "monotonic", lambda s=seconds: typed_at + s + ALL_EVERY)
            goes_first.append(line.goes_first)
        assert goes_first[1:] == [True, True, False, False], "once at first, then after a pause"
        ticked = list[object]()
        monkeypatch.setattr(it.app.main.panes, "show", lambda *shown: ticked.append(shown))
        for first, ticks in ((True, 0), (False, 1)):
            monkeypatch.setattr(tools.FilterLine, "goes_first", first)
            ticked.clear()
            it.app.main.tick()
            assert len(ticked) == ticks
