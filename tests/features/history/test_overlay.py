"""`H`: a shift that was, on the console of one that goes on."""

import base64
import time
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from fleet_tui.features.history import overlay, replaying
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.console_pilot import Console
from tests.support.key_effects import overlays
from tests.support.past import kept_history, put
from tests.support.planted_console import planted
from tests.support.shift import shift


@asynccontextmanager
async def past_console(folder: Path, size: tuple[int, int] = (120, 40)) -> AsyncIterator[Console]:
    """A console an hour after a shift began."""
    put(folder, [*shift(time.time() - 3600), *shift(time.time() - 3000, "robot_1")])
    files = ConsoleFiles()
    with kept_history(folder) as files.history:
        async with planted(2, 2, size=size, files=files) as it:
            await it.press("H")
            await it.shows("link: up", "history-rows")
            yield it


async def test_pages_by_keys_and_back(tmp_path: Path) -> None:
    async with past_console(tmp_path) as it:
        assert "[1 Events]" in it.text and "to now" in it.text
        await it.press("2")
        await it.shows("█ blocked", "history-rows")
        await it.press("tab")
        await it.shows("[3 Batteries]")
        await it.shows(" 60%", "history-rows")
        await it.press("4")
        await it.shows("stuck robot_0 once", "history-rows")
        await it.press("5")
        await it.shows("blocked here", "history-rows")
        await it.press("escape")
        assert overlays(it) == []


async def test_a_filter_is_of_all_pages_and_is_cleared_first(tmp_path: Path) -> None:
    async with past_console(tmp_path) as it:
        await it.press("slash")
        await it.type("robot_1 lost")
        await it.press("enter")
        rows = it.pane("history-rows")
        assert "robot_1 order 2 Store -> Base: lost" in rows and "robot_0" not in rows
        await it.press("escape")
        assert "robot_0 order 1" in it.pane("history-rows") and overlays(it) == ["history"]


async def test_its_rows_are_sorted_marked_and_copied_like_those_of_every_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with past_console(tmp_path) as it:
        sent: list[str] = []
        monkeypatch.setattr(it.driver, "write", sent.append)
        await it.press("S")
        await it.shows(" by robot", "history-rows")
        await it.press("slash")
        await it.type("kind:order robot:robot_1")
        await it.press("enter", "space", "down", "space", "y")
        await it.shows("2 marked", "history-rows")
        await it.shows("2 rows, ", "history-keys")
        text = base64.b64decode(sent[-1].split(";")[2][:-1]).decode()
        assert ["robot_1 order" in line for line in text.splitlines()] == [True, True]
        await it.press("escape")
        await it.hides("kind:order")


async def test_another_time_is_read(tmp_path: Path) -> None:
    async with past_console(tmp_path) as it:
        await it.press("minus")
        await it.shows("8 h to now")
        await it.press(*["comma"] * 3)
        await it.shows("nothing happened in this time", "history-rows")
        await it.press(*["full_stop"] * 3)
        await it.shows("8 h to now")
        await it.press(*["plus"] * 4)
        await it.shows("15 min to now")


async def test_enter_on_a_robot_shows_its_curve_or_its_events(tmp_path: Path) -> None:
    async with past_console(tmp_path) as it:
        await it.press("3")
        await it.shows("robot_1", "history-rows")
        await it.press("enter")
        await it.shows("Battery of robot_0")
        await it.shows("100 %", "history-rows")
        await it.press("escape")
        await it.shows("Batteries 2")
        await it.press("2")
        await it.shows("driving", "history-rows")
        await it.press("down", "enter")
        await it.shows("robot_1 order 1", "history-rows")
        assert "[1 Events]" in it.text and "robot_0 order" not in it.pane("history-rows")


async def test_one_key_from_an_alarm_opens_the_recording(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ran: list[Sequence[str]] = []
    tape = tmp_path / "a.jsonl.gz"
    monkeypatch.setattr(replaying, "recording_at", lambda _folder, at, _also: (tape, at - 60))

    def run(command: Sequence[str]) -> str:
        ran.append(command)
        return ""

    monkeypatch.setattr(overlay, "run_in_terminal", run)
    async with past_console(tmp_path) as it:
        await it.press("4")
        await it.shows("stuck robot_0", "history-rows")
        await it.press("o")
        await it.shows("a recording can't use this terminal", "history-keys")
        assert ran == []  # under a pilot there is no terminal to give


async def test_a_console_without_a_history_says_so() -> None:
    async with planted(2, 2) as it:
        await it.press("H")
        await it.shows("this console keeps no history: set days in [history]", "history-rows")


@pytest.mark.parametrize("size", [(60, 15), (80, 24), (200, 60)])
async def test_at_every_size(tmp_path: Path, size: tuple[int, int]) -> None:
    async with past_console(tmp_path, size) as it:
        for page in "2345":
            await it.press(page)
        await it.shows("blocked here" if size[0] > 60 else "Places", "history-rows")
