"""Commands in a session of their own: they outlive who started them, and leave their outcome and log."""

import os
import stat
from collections.abc import Callable
from pathlib import Path

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.programs.arguments import start_session
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.programs.session import LARGEST_LOG
from fleet_tui.programs.session_state import session_status, stop_session
from tests.support.polling import until

RUNNING, STOPPED, FAILED = ProgramState.RUNNING, ProgramState.STOPPED, ProgramState.FAILED


async def started(folder: Path, *command: str) -> EndedProcess:
    return await run(start_session(ProgramEntry("job", start=list(command)), folder), 20.0)


async def comes(folder: Path, holds: Callable[[ProgramStatus], object]) -> ProgramStatus:
    await until(lambda: holds(session_status(folder, "job", 0.0)))
    return session_status(folder, "job", 0.0)


def sizes(folder: Path) -> list[int]:
    return [path.stat().st_size for path in folder.glob("job.log*")]


def modes(folder: Path) -> set[int]:
    return {stat.S_IMODE(path.stat().st_mode) for path in folder.iterdir()}


async def test_it_runs_after_its_starter_and_stops_when_told(tmp_path: Path) -> None:
    assert session_status(tmp_path, "job", 0.0).state is STOPPED
    assert (await started(tmp_path, "sleep", "60")).code == 0
    found = session_status(tmp_path, "job", 0.0)
    assert found.state is RUNNING and found.since and found.instance and not found.has_systemd
    again = await started(tmp_path, "sleep", "60")
    assert again.code == 1 and "is already running" in again.output
    assert stop_session(tmp_path, "job") == ""
    assert (await comes(tmp_path, lambda one: one.state is not RUNNING)).state is STOPPED
    assert stop_session(tmp_path, "job") == "is not running"


async def test_its_exit_status_and_log_are_kept(tmp_path: Path) -> None:
    await started(tmp_path, "sh", "-c", "echo hello; exit 3")
    found = await comes(tmp_path, lambda one: one.state is FAILED)
    assert found.detail == "exit status 3"
    assert (tmp_path / "job.log").read_text() == "hello\n"
    assert modes(tmp_path) == {0o600}


async def test_what_can_not_be_run_says_so(tmp_path: Path) -> None:
    ended = await started(tmp_path, "no-such-program")
    assert ended.code == 1 and "no-such-program: No such file or directory: check `start`" in ended.output


async def test_a_flood_is_bounded_on_the_disk(tmp_path: Path) -> None:
    await started(tmp_path, "yes")
    old = tmp_path / "job.log.1"
    await comes(tmp_path, lambda _: old.exists())
    stop_session(tmp_path, "job")
    await comes(tmp_path, lambda one: one.state is STOPPED)
    assert sum(sizes(tmp_path)) < 3 * LARGEST_LOG


async def test_a_session_that_was_killed_is_no_running_one(tmp_path: Path) -> None:
    await started(tmp_path, "sleep", "0.5")
    found = session_status(tmp_path, "job", 0.0)
    os.kill(int((tmp_path / "job.session").read_text().split('"pid": ')[1].split(",")[0]), 9)
    after = await comes(tmp_path, lambda one: one.state is not RUNNING)
    assert found.state is RUNNING and (after.state, after.detail) == (FAILED, "killed with its session")
