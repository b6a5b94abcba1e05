"""The audit log on the screen, with keys alone."""

import csv
import errno
import stat
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from datetime import datetime
from pathlib import Path

import pytest
from textual.widgets import Input

from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.log import auditing, encode
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.storage.line_file import LineFile
from fleet_tui.ui.controllers.files import READ_ONLY
from tests.support.console_pilot import Console, console
from tests.support.planted_console import SITE, PlantedConsole, planted
from tests.support.records import record
from tests.support.watched_store import config_of


@asynccontextmanager
async def audited(folder: Path, size: tuple[int, int] = (120, 40)) -> AsyncIterator[PlantedConsole]:
    """A console that keeps its log in a folder."""
    config = config_of(SITE, 2)
    async with planted(config=config, size=size) as it:
        with auditing(folder, config, it.store) as it.app.main.files.audit:
            yield it


def has_exports(folder: Path) -> bool:
    return any(folder.rglob("*.csv"))


def field(it: Console) -> str:
    return it.app.main.query_one("#audit-filter", Input).value


def exported(folder: Path) -> list[dict[str, str]]:
    """The rows of the one export in a folder, which only its owner may read."""
    (written,) = folder.glob("audit-*.csv")
    assert stat.S_IMODE(written.stat().st_mode) == 0o600
    with written.open(newline="") as file:
        return list(csv.DictReader(file))


async def open_log(it: Console, wait_for: str = "Audit log") -> None:
    await it.press("L")
    await it.shows(wait_for)


async def test_a_command_and_its_steps_are_found_again(tmp_path: Path) -> None:
    async with audited(tmp_path) as it:
        await it.press("p")
        await it.shows("robot_0 pause: confirmed")
        await it.press("r")
        await it.shows("robot_0 resume: confirmed")
        await open_log(it, "robot_0 pause: checked")
        await it.type("pause:")
        await it.hides("robot_0 resume: sent")
        await it.press("enter")
        await it.shows("Audit log 4")
        assert field(it).startswith("request:")
        for step in ("checked", "sent", "accepted", "confirmed"):
            assert f"robot_0 pause: {step}" in it.pane("audit-rows")
        await it.press("enter")
        await it.shows("robot_0 resume: sent")
        await it.press("escape")
        await it.hides("Audit log")


async def test_what_is_typed_right_after_the_key_belongs_to_the_field(tmp_path: Path) -> None:
    """`p`, `x`, `P` in a search must not pause or cancel."""
    async with audited(tmp_path) as it:
        await it.press("L", "p", "x", "P")
        await it.shows("no matching record")
        assert field(it) == "pxP" and it.sent == []


async def test_from_the_palette_at_80_by_24_with_the_marked_record_in_full(tmp_path: Path) -> None:
    async with audited(tmp_path, (80, 24)) as it:
        await it.press("p")
        await it.shows("confirmed")
        await it.press(":")
        await it.type("audit")
        await it.press("enter")
        await it.shows("robot_0 pause: accepted")
        await it.shows("confirmed by the robot")
        await it.press("down")
        await it.shows("accepted: paused")
        assert "robot_0" in it.text.splitlines()[0]


async def test_what_matches_goes_to_a_new_file_for_its_owner(tmp_path: Path) -> None:
    async with audited(tmp_path) as it:
        await it.press("p", "P")
        await it.shows("pause all: 2 confirmed")
        await open_log(it, "robot_1 pause: confirmed")
        await it.type("robot:robot_1")
        await it.hides("robot_0 pause: sent")
        await it.press("ctrl+s")
        await it.shows("4 records written to")
    rows = exported(tmp_path)
    assert {row["robot"] for row in rows} == {"robot_1"}
    assert [row["change"] for row in rows] == ["confirmed", "accepted", "sent", "checked"]


async def test_after_tab_its_rows_are_sorted_and_copied_like_those_of_every_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with audited(tmp_path) as it:
        sent: list[str] = []
        monkeypatch.setattr(it.driver, "write", sent.append)
        await it.press("p")
        await it.shows("robot_0 pause: confirmed")
        await open_log(it, "robot_0 pause: checked")
        await it.press("tab", "S")
        await it.shows(" by time", "audit-rows")
        assert it.pane("audit-rows").index("checked") < it.pane("audit-rows").index("confirmed")
        await it.press("space", "up", "space", "y")
        await it.shows("2 rows, ", "message")
        assert sent
        await it.press("slash", "z", "S")
        await it.shows("no matching record")
        assert field(it) == "zS"


async def test_a_read_only_console_exports_nothing(tmp_path: Path) -> None:
    async with audited(tmp_path) as it:
        it.app.main.files.refusal = READ_ONLY
        await open_log(it, "console: opened")
        await it.press("ctrl+s")
        await it.shows("not here: this console is read-only")
    assert not has_exports(tmp_path)


async def test_a_time_that_is_none_is_answered_in_place_of_the_list(tmp_path: Path) -> None:
    async with audited(tmp_path) as it:
        await open_log(it, "console: opened")
        await it.type("since:2x")
        await it.shows("'2x' is not a time: use 30m, 2h")


async def test_hostile_records_and_foreign_lines_do_not_act_on_the_screen(tmp_path: Path) -> None:
    odd = encode(record("\x1b[2J\u202e[red]x", change="refused"))
    (tmp_path / FILE_NAME).write_bytes(b"rubbish\n" + odd + odd[:50])
    async with audited(tmp_path) as it:
        await open_log(it, "refused (␛[2J\ufffd[red]x)")
        await it.shows("2 unreadable lines")


async def test_the_console_without_a_log_says_so() -> None:
    async with planted() as it:
        await open_log(it, "no audit log")


async def test_a_full_disk_stands_on_the_screen_and_dispatch_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    log = tmp_path / FILE_NAME

    def full(_file: LineFile, _line: bytes) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    append = LineFile.append
    monkeypatch.setattr(LineFile, "append", full)
    async with audited(tmp_path) as it:
        await it.press("p")
        await it.shows("robot_0 pause: confirmed")
        await it.shows("audit: not written: No space left on device")
        monkeypatch.setattr(LineFile, "append", append)
        await it.hides("audit: not written")
    found = [one.change for one in AuditReader(log).newest_first()][::-1]
    assert found == ["opened", "checked", "sent", "accepted", "confirmed", "closed"]


async def test_a_command_is_in_the_log_before_it_is_on_the_wire(
    server: RosbridgeServer, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[list[str]] = []
    answer: Callable[..., object] = server.world.answer

    def look(*args: object, **more: object) -> object:
        seen.append([one.change for one in AuditReader(tmp_path / FILE_NAME).newest_first()])
        return answer(*args, **more)

    monkeypatch.setattr(server.world, "answer", look)
    config = config_of(server.url, 2)
    async with console(config) as it:
        with auditing(tmp_path, config, it.store) as it.app.main.files.audit:
            await it.press("p")
            await it.shows("robot_0 pause: confirmed")
    assert len(seen) == 1 and "checked" in seen[0]


async def test_who_commands_stands_in_the_status_line(tmp_path: Path) -> None:
    async with audited(tmp_path) as it:
        audit = it.app.main.files.audit
        assert audit is not None
        await it.shows(f"{audit.origin.operator}  {datetime.now():%H:}")
