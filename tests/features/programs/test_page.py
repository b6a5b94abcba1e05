"""Programs of the robot servers, by keys alone: looked at, asked, changed, logged."""

import asyncio
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace
from textual.widgets import Input

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import Operator
from fleet_tui.config.start import initial_state
from fleet_tui.features.programs import requests as controller
from fleet_tui.features.programs.page import Programs
from fleet_tui.model.programs.program import ChangeOutcome
from fleet_tui.programs import watch
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.log import auditing
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.state.store import Store
from tests.support.console_pilot import Console
from tests.support.planted_console import SITE, planted
from tests.support.stand_ins import with_status
from tests.support.watched_store import config_of

PANE = "programs-rows"


@asynccontextmanager
async def with_programs(
    programs: Sequence[ProgramEntry], operator: Operator | None = None, size: tuple[int, int] = (120, 40)
) -> AsyncIterator[Console]:
    config = replace(config_of(SITE, 1), programs=list(programs), operator=operator or Operator("ana"))
    async with planted(config=config, size=size) as it:
        yield it


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(watch, "EVERY", 0.1)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))


def audited(folder: Path) -> list[str]:
    records = reversed(list(AuditReader(folder / FILE_NAME).newest_first()))
    return [f"{one.change} {one.words}" for one in records if one.change.startswith("program")]


async def test_without_programs_the_key_says_how_to_configure_one() -> None:
    async with with_programs([], size=(80, 24)) as it:
        await it.press("J")
        await it.shows("No program is configured.", PANE)
        await it.shows('unit = "rosbridge.service"', PANE)
        await it.press("enter", "J")
        await it.hides("No program is configured.")


async def test_a_program_is_started_and_stopped_after_a_question_and_audited(tmp_path: Path) -> None:
    nav = with_status(tmp_path)
    async with with_programs([nav, replace(nav, name="map", needs=["nav"])]) as it:
        with auditing(tmp_path, config_of(SITE, 1), it.store) as it.app.main.files.audit:
            await it.press("J")
            await it.shows("○ stopped", PANE)
            await it.press("enter")
            await it.shows("nav: stopped")
            await it.press("1")
            await it.shows("Start nav? It is stopped.")
            await it.press("n")
            await it.shows("○ stopped", PANE)
            assert not (tmp_path / "runs").exists()
            await it.press("enter", "1", "y")
            await it.shows("nav: start confirmed")
            await it.shows("● running", PANE)
            await it.press("enter", "1")
            await it.shows("map needs it, and is running.")
            await it.press("y")
            await it.shows("nav: stop confirmed")
            await it.press("escape")
            await it.hides("Programs")
            assert it.app.main.focused is it.app.main.features.map
    assert audited(tmp_path) == [
        *("program start nav: sent", "program start nav: confirmed"),
        *("program stop nav: sent", "program stop nav: confirmed"),
    ]


@pytest.mark.parametrize(
    ("operator", "reason"),
    [(Operator("ana", read_only=True), "read-only"), (Operator("ana", armed=False), "is not armed")],
)
async def test_who_may_not_command_looks_but_starts_nothing(
    tmp_path: Path, operator: Operator, reason: str
) -> None:
    nav = replace(with_status(tmp_path), log=["echo", "a line"])
    async with with_programs([nav], operator) as it:
        await it.press("J")
        await it.shows("○ stopped", PANE)
        await it.press("enter", "1")
        await it.shows(reason, "message")
        assert "Start nav?" not in it.text and not (tmp_path / "runs").exists()
        await it.press("enter", "2")
        await it.shows("a line", PANE)


@pytest.mark.parametrize("closes", [("J",), ("f1", "escape"), ("escape", "escape")])
async def test_a_closed_log_keeps_no_focus(tmp_path: Path, closes: tuple[str, ...]) -> None:
    nav = replace(with_status(tmp_path), log=["echo", "a line"])
    async with with_programs([nav]) as it:
        await it.press("J")
        await it.shows("○ stopped", PANE)
        await it.press("enter", "2")
        await it.shows("a line", PANE)
        await it.press("enter", *closes)
        programs = it.app.main.query_one(Programs)
        programs.tick()
        await it.settled()
        assert not programs.is_open
        assert it.app.main.focused is it.app.main.features.map


async def test_they_are_sorted_by_the_columns_that_sort(tmp_path: Path) -> None:
    nav = with_status(tmp_path)
    async with with_programs([nav, replace(nav, name="map_10"), replace(nav, name="map_9")]) as it:
        await it.press("J")
        await it.shows("○ stopped", PANE)
        await it.press("S")
        await it.shows("by program", PANE)
        assert it.pane(PANE).index("map_9") < it.pane(PANE).index("map_10")
        await it.press("slash")
        await it.type("map_1")
        await it.press("enter")
        await it.hides("map_9", PANE)
        await it.press("escape")
        await it.shows("map_9", PANE)
        await it.press("S", "S")
        assert it.pane(PANE).index("map_10") < it.pane(PANE).index("map_9"), "as configured"


async def test_a_console_that_is_disarmed_during_the_question_starts_nothing(tmp_path: Path) -> None:
    async with with_programs([with_status(tmp_path)]) as it:
        await it.press("J")
        await it.shows("○ stopped", PANE)
        await it.press("enter", "1")
        it.app.main.dispatch.arm()
        await it.press("y")
        await it.shows("is not armed", "message")
        assert not (tmp_path / "runs").exists()


async def test_a_fault_of_our_own_and_a_closed_console_leave_an_outcome(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def fails(program: ProgramEntry, verb: str, folder: Path) -> ChangeOutcome:
        raise RuntimeError("broken")

    nav = with_status(tmp_path)
    slow = replace(nav, name="slow", start=["sleep", "60"])
    store = Store(initial_state(config_of(SITE, 1), 0.0))
    with auditing(tmp_path, config_of(SITE, 1), store) as audit:
        async with with_programs([slow, nav]) as it:
            it.app.main.files.audit = audit
            await it.press("J")
            await it.shows("stopped", PANE)
            await it.press("enter", "1", "y", "enter", "1")
            await it.shows("slow: start is still under way", "message")
            monkeypatch.setattr(controller, "change", fails)
            await it.press("j", "enter", "1", "y")
            await it.shows("nav: start not confirmed (internal error: broken)")
            (task,) = it.app.main.query_one(Programs).requests.under_way
        task.cancel()
        await asyncio.wait({task})
    assert audited(tmp_path) == [
        *("program start slow: sent", "program start nav: sent"),
        "program start nav: not confirmed (internal error: broken)",
        "program start slow: not confirmed (the console was closed)",
    ]


async def test_a_log_follows_its_end_and_is_filtered_as_one_types(tmp_path: Path) -> None:
    script = "for n in 1 2 3; do echo line $n q; done; printf '\\033[2J\\377bad J\\n'; "
    script += "while [ ! -e more ]; do sleep 0.05; done; echo more"
    log = ["sh", "-c", f"cd {tmp_path}; {script}; exec sleep 60"]
    nav = replace(with_status(tmp_path), log=log)
    async with with_programs([nav], size=(80, 24)) as it:
        await it.press("J")
        await it.shows("○ stopped", PANE)
        await it.press("enter", "2")
        await it.shows("␛[2J\ufffdbad J", PANE)
        (tmp_path / "more").touch()
        await it.shows("▸more", PANE)
        await it.type("q")
        await it.shows("5 lines /q: 3", PANE)
        assert "bad" not in it.pane(PANE)
        await it.press("escape")
        await it.shows("○ stopped", PANE)
        await it.press("enter", "2")
        await it.shows(" 5 lines", PANE)
        assert it.app.main.query_one("#programs-filter", Input).value == ""


async def test_programs_that_hang_flood_or_are_missing_are_told_and_hold_up_nothing(tmp_path: Path) -> None:
    nav = with_status(tmp_path)
    forms = {
        "hangs": ["sleep", "60"],
        "floods": ["yes"],
        "missing": ["no-such-program"],
        "odd": ["sh", "-c", "printf '\\033[2J\\377x'; exit 4"],
    }
    programs = [replace(nav, name=name, status=status) for name, status in forms.items()]
    async with with_programs([*programs, nav]) as it:
        await it.press("J")
        await it.shows("yes: stopped after 256 kB of output", PANE)
        await it.shows("no-such-program: not found: install it", PANE)
        await it.shows("␛[2J\ufffdx", PANE)
        await it.shows("looking ...", PANE)
        await it.shows("○ stopped", PANE)
        (tmp_path / "runs").touch()
        await it.shows("● running", PANE)


async def test_nothing_runs_once_it_is_closed(tmp_path: Path) -> None:
    noted = tmp_path / "looks"
    status = ["sh", "-c", f"echo >> {noted}"]
    async with with_programs([replace(with_status(tmp_path), status=status)]) as it:
        await it.press("J")
        await it.shows("● running", PANE)
        await it.press("escape")
        overlay = it.app.main.query_one(Programs)
        overlay.tick()
        assert not [
            task for task in asyncio.all_tasks() if "ProgramWatch" in repr(task) and not task.cancelling()
        ]
