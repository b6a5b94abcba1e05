"""Routines by keys alone: checked, asked, led, held, resumed, left and continued."""

import asyncio
import os
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Config, Operator, RoutinesConfig
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.log import auditing
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.planted_console import SITE, planted
from tests.support.routine_files import hurry, routine
from tests.support.scenario import calls
from tests.support.watched_store import config_of

PANE = "routines-rows"
DAY = "for robot_0\ncarry Base Consumidores\nrun ./gate\nend\n"


@pytest.fixture(autouse=True)
def gate(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The program of the routine runs until this is written to."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    routine(tmp_path, DAY)
    program = tmp_path / "routines" / "gate"
    program.write_text(f"#!/bin/sh\nexec cat {tmp_path}/fifo\n")
    program.chmod(0o700)
    os.mkfifo(tmp_path / "fifo")
    return tmp_path / "fifo"


def configured(url: str, folder: Path, operator: Operator | None = None) -> Config:
    routines = RoutinesConfig(str(folder / "routines"))
    return replace(config_of(url, 1), routines=routines, operator=operator or Operator("ana"))


def audited(folder: Path) -> list[str]:
    records = reversed(list(AuditReader(folder / FILE_NAME).newest_first()))
    return [f"{one.change}: {one.words}" for one in records if one.change.startswith("routine")]


async def start_day(it: Console) -> None:
    """Start the routine, until its program runs."""
    await it.press("B")
    await it.shows("○ never run", PANE)
    await it.press("enter", "1")
    await it.shows("Start day")
    await it.press("y")
    await it.shows("line 3: run ./gate", PANE)


async def test_it_is_started_after_a_check_and_a_question_and_led_to_its_end(
    server: RosbridgeServer, tmp_path: Path, gate: Path
) -> None:
    hurry(server)
    async with console(configured(server.url, tmp_path), (80, 24)) as it:
        with auditing(tmp_path, config_of(server.url, 1), it.store) as it.app.main.files.audit:
            await it.press("B")
            await it.shows("○ never run", PANE)
            await it.press("enter", "1")
            await it.shows("Start day with robot_0?")
            await it.press("n")
            assert calls(server) == []
            await it.press("enter", "1")
            await it.shows("Start day with robot_0?")
            await it.press("y")
            await it.shows("line 3: run ./gate", PANE)
            await it.shows("run by this console", PANE)
            await asyncio.to_thread(gate.write_text, "open\n")
            await it.shows("○ done", PANE)
        assert calls(server) == ["Execute_order"]
        assert audited(tmp_path) == [
            "routine started: day: robot_0",
            "routine program: day robot_0: run ./gate",
            "routine done: day robot_0",
        ]


async def test_without_a_link_it_is_held_and_a_person_resumes(tmp_path: Path) -> None:
    async with planted(config=configured(SITE, tmp_path)) as it:
        hurry(it.fleet.server)
        await start_day(it)
        it.lose_link()
        await it.shows("△ held", PANE)
        it.find_link()
        await it.shows("△ held", PANE)
        await it.press("down", "enter", "1")
        await it.shows("● running", PANE)
        await it.press("enter")
        await it.shows("Pause: running orders continue")
        await it.press("1")
        await it.shows("◇ paused", PANE)
        await it.press("enter", "3")
        await it.shows("○ stopped", PANE)
        await it.hides("robot_0 ", PANE)


async def test_problems_are_shown_in_place_of_a_start(tmp_path: Path) -> None:
    routine(tmp_path, "for robot_0\ngo Bse\nrun absent\nend\n")
    async with planted(config=configured(SITE, tmp_path)) as it:
        await it.press("B")
        await it.shows("○ never run", PANE)
        await it.press("enter", "1")
        await it.shows("day: not started", PANE)
        await it.shows("line 2: robot_0 has no place 'Bse', did you mean Base?", PANE)
        await it.shows("line 3: absent: not found", PANE)
        await it.press("escape")
        await it.shows("○ never run", PANE)
        routine(tmp_path, "for robot_0\nwait 5 s\nend\n")
        await it.press("enter", "2")
        await it.shows("line 2    wait 5 s (about 5 s)", PANE)
        await it.press("B")
        await it.hides("wait 5 s")


async def test_a_console_that_is_not_armed_starts_nothing(tmp_path: Path) -> None:
    async with planted(config=configured(SITE, tmp_path, Operator("ana", armed=False))) as it:
        await it.press("B")
        await it.shows("○ never run", PANE)
        await it.press("enter", "1")
        await it.shows("day: not started: not sent: this console is not armed")
        assert it.sent == []


@pytest.mark.nightly
async def test_leaving_is_asked_and_the_next_console_takes_it_up(
    server: RosbridgeServer, tmp_path: Path
) -> None:
    hurry(server)
    async with console(configured(server.url, tmp_path)) as it:
        await start_day(it)
        await it.press("escape", "q")
        await it.shows("Leave day? Running orders continue")
        await it.pilot.press("y")
    async with console(configured(server.url, tmp_path)) as it:
        await it.press("B")
        await it.shows("△ held", PANE)
        await it.press("enter", "1")
        await it.shows("Continue day with robot_0?")
        await it.press("y")
        await it.shows("the process that ran it has ended", PANE)
        await it.shows("run by this console", PANE)
    assert calls(server) == ["Execute_order"]
