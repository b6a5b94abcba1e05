"""A fault of the console's own: it is said and logged, and the console goes on."""

import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.console.features import Features
from fleet_tui.console.main_screen import MainScreen
from fleet_tui.records.audit import reader
from fleet_tui.records.audit.log import auditing
from fleet_tui.ui.screens.tables import pane_rows
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of

SAID = "internal error: broken here (see the log file)"


def broken(left: list[None], real: Callable[..., Any]) -> Callable[..., Any]:
    """A function that fails at first, as often as `left` is long."""

    def function(*args: Any) -> Any:
        if left:
            left.pop()
            raise RuntimeError("broken here")
        return real(*args)

    return function


def logged(caplog: pytest.LogCaptureFixture) -> list[str]:
    """The console's message on its own faults."""
    return [
        f"{record.getMessage()}: {record.exc_info[1]}"
        for record in caplog.records
        if record.levelno >= logging.ERROR and record.exc_info
    ]


@pytest.mark.own_faults
async def test_a_key_that_fails_costs_nothing_else(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(Features, "_all_orders", broken([None], Features._all_orders))
    async with planted(2, 2) as it:
        await it.press("*")
        await it.shows(SAID)
        assert logged(caplog) == ["action all_orders: broken here"]
        await it.press("*")
        await it.shows("Queue all robots")
        await it.press("p")
        await it.shows("paused")


@pytest.mark.own_faults
async def test_ticks_that_fail_are_tried_again(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async with planted(2, 2) as it:
        left = [None] * 3
        monkeypatch.setattr(pane_rows, "fleet_table", broken(left, fleet_table))
        await it.until(lambda _state: not left)
        await it.shows(SAID)
        assert logged(caplog) == ["tick: broken here"]
        await it.press("]")
        await it.shows("Queue robot_1", "queue")


class WordlessError(Exception):
    """An error without words."""


@pytest.mark.own_faults
@pytest.mark.parametrize(
    ("error", "said"),
    [
        (RuntimeError("a\x1b]52;c;QQ==\x07\nb\u202e"), "internal error: a␛]52;c;QQ==␇␊b\ufffd (see the log"),
        (WordlessError(), "internal error: WordlessError (see the log"),
        (RuntimeError("x" * 5_000_000), "… (5,000,000 characters) (see the log file)"),
    ],
)
async def test_the_words_of_a_fault_are_shown_as_text(
    monkeypatch: pytest.MonkeyPatch, error: Exception, said: str
) -> None:
    def fails(_self: MainScreen) -> None:
        raise error

    monkeypatch.setattr(Features, "_all_orders", fails)
    async with planted(2, 2) as it:
        await it.press("*")
        await it.until(lambda _state: said in it.app.main.notices.text)
        await it.shows("internal error: ", "message")
        assert it.pane("message").isprintable()


@pytest.mark.own_faults
async def test_what_is_read_beside_the_screen_may_fail(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(reader.AuditReader, "newest_first", broken([None], reader.AuditReader.newest_first))
    config = config_of(SITE, 2, 2)
    async with planted(config=config) as it:
        with auditing(tmp_path, config, it.store) as it.app.main.files.audit:
            await it.press("L")
            await it.shows(SAID)
            assert logged(caplog) == ["worker: broken here"]
            await it.press("escape", "p")
            await it.shows("paused")
