"""Programs of a routine: found, run with the robot's name, ended with it."""

import time
from pathlib import Path

import pytest

from fleet_tui.features.routines.blocks import RunBlock
from fleet_tui.features.routines.lane import ProgramEnded
from fleet_tui.features.routines.programs import ProgramRun, program_path, program_problem
from fleet_tui.text.language import Message
from tests.support.polling import HANGS


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "check"
    path.write_text('#!/bin/sh\necho first\nprintf "\\033[2J$FLEET_TUI_ROBOT $1 in $(pwd)"\nexit $2\n')
    path.chmod(0o700)
    return path


def ended(folder: Path, *arguments: str, within: float = HANGS) -> ProgramEnded:
    run = ProgramRun(folder, RunBlock(1, "", arguments, within), "robot_7")
    until = time.monotonic() + 30.0
    while run.ended is None and time.monotonic() < until:
        run.join()
    assert run.ended is not None
    return run.ended


def test_it_is_found_beside_the_routine_then_on_path(script: Path) -> None:
    folder = script.parent
    assert program_path(folder, "check") == program_path(folder, "./check") == str(script)
    assert program_path(folder, "sh").endswith("/sh") and program_path(folder, "./sh") == ""
    assert program_problem(folder, ["check"]) == ""


def test_a_program_that_is_absent_or_not_executable_is_told_with_the_remedy(script: Path) -> None:
    script.chmod(0o600)
    assert program_problem(script.parent, ["check"]).endswith(f"run chmod +x {script}")
    assert "nor on PATH: correct the name" in program_problem(script.parent, ["absent-program"])
    assert "nor on PATH" in program_problem(script.parent, ["a\0b"])


def test_its_exit_code_decides_and_its_last_line_is_told(script: Path) -> None:
    assert ended(script.parent, "check", "a b", "0").is_done
    failed = ended(script.parent, "check", "a b", "3")
    assert not failed.is_done and failed.words.startswith("exit status 3: ")
    assert f"robot_7 a b in {script.parent}" in failed.words and "\x1b" not in failed.words


def test_it_ends_when_its_time_is_up(script: Path) -> None:
    assert ended(script.parent, "sleep", "60", within=0.2) == ProgramEnded(
        False, Message("not ended within 0 s")
    )


def test_one_that_cannot_be_started_fails(tmp_path: Path) -> None:
    assert not ended(tmp_path, "absent-program").is_done


def test_a_person_ends_it(script: Path) -> None:
    run = ProgramRun(script.parent, RunBlock(1, "", ("sleep", "60"), 60.0), "robot_7")
    run.end()
    for _ in range(20):
        run.join()
    assert run.ended == ProgramEnded(False, Message("ended by a person"))
    run.end()
