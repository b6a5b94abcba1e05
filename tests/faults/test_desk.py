"""Several operators: the folder of a desk that fails, and two who command the same robot at once."""

import os
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from fleet_tui.commands.rivals import rivals_text
from fleet_tui.model.commands import Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.records.desk.fact_file import FILE
from tests.support.fault_report import report
from tests.support.fleets import commanded
from tests.support.shared_desk import R3, DeskConsole, at_desk

CONSOLE = """
import os, sys, time
from pathlib import Path
from fleet_tui.records.desk import fact_file
from fleet_tui.model.history.facts import Note
from tests.support.polling import eventually
from tests.support.shared_desk import DeskConsole
fact_file.LARGEST = 1
os.setgroups([])
os.setgid(int(sys.argv[3]))
os.setuid(int(sys.argv[4]))
one = DeskConsole(Path(sys.argv[1]), sys.argv[2])
one.desk.start(one.post)
began = time.monotonic()
one.desk.share_note(Note(time.time(), sys.argv[2], "lift B is slow"))
eventually(lambda: one.desk.notes)
print(*one.desk.notes, sep="; ")
print(time.monotonic() - began, flush=True)
sys.stdin.read()
one.desk.close()
"""
GROUP, ANA, BEN, CLEO = 61000, 61001, 61002, 61003


@pytest.mark.skipif(os.getuid() != 0, reason="two real users need root")
def test_a_sticky_folder_of_two_users_has_each_note_once() -> None:
    """Whose file it is may replace it, the other one may only append."""
    with TemporaryDirectory(prefix="desk-") as name:
        folder = Path(name)
        os.chown(folder, 0, GROUP)
        folder.chmod(0o3770)
        (folder / FILE).touch()
        os.chown(folder / FILE, ANA, GROUP)
        (folder / FILE).chmod(0o660)
        consoles = [
            subprocess.Popen(
                [sys.executable, "-c", CONSOLE, name, operator, str(GROUP), str(user)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            for user, operator in ((BEN, "ben"), (CLEO, "cleo"))
        ]
        try:
            said = [one.stdout.readline() for one in consoles if one.stdout is not None]
            noticed = max(float(one.stdout.readline()) for one in consoles if one.stdout is not None)
            for one in consoles:
                one.communicate(timeout=30)
        finally:
            for one in consoles:
                one.kill()
                one.wait()
        assert said == ["desk: facts.jsonl grows, it can't be shortened: Operation not permitted\n"] * 2
        assert (folder / FILE).read_text().count("lift B is slow") == 2
    report(
        "the desk's folder is sticky",
        "two users share the file of a third",
        "all is shared, once; the top line says that the file grows",
        noticed,
        None,
    )


def test_two_operators_command_a_robot_at_once(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as consoles:
        began = time.monotonic()
        ana, ben = consoles
        given: list[tuple[DeskConsole, Command]] = [(ana, PauseRobot(R3)), (ben, ResumeRobot(R3))]
        for one, command in given:
            one.tick(began)
            for step in commanded(7, command, Stage.SENT, at=began):
                one.post(step)
        for one in consoles:
            one.becomes(lambda state: rivals_text(state, R3))
        noticed = time.monotonic() - began
    report(
        "two operators command a robot at once",
        "a pause and a resume from two consoles of a desk",
        "both: also commanded by the other, from where and what",
        noticed,
        None,
    )
