"""The log on a disk that hangs, and where its folder goes away."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.config.log_file import state_folder, state_problem
from fleet_tui.config.schema import Config
from fleet_tui.records.audit.log import auditing
from fleet_tui.state.store import Store
from tests.support.fleets import fleet
from tests.support.users import two_users

# More messages than may wait, while the first is being written; `answers` says whether it ever is.
PROGRAM = """
import logging, sys, threading, time
from fleet_tui.config import log_file
from fleet_tui.ui.terminal.ending import end_within

hangs, answers = threading.Event(), threading.Event()
emit = log_file._LogFile.emit

def slowly(self, record):
    hangs.set()
    answers.wait()
    emit(self, record)

log_file.WAITING = 10
log_file._LogFile.emit = slowly
log_file.log_to_file(False)
log = logging.getLogger("x")
log.warning("n0")
hangs.wait()
for n in range(1, 15):
    log.warning("n%d", n)
if sys.argv[1] == "answers":
    answers.set()
    while logging.getLogger().handlers[0].queue.qsize():
        time.sleep(0.01)
    log.warning("at last")
end_within(1.0, 7)
"""


@pytest.mark.parametrize("then", ["answers", "hangs"])
def test_what_can_not_wait_is_counted_and_nothing_is_said_on_the_screen(tmp_path: Path, then: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, then],
        env={**os.environ, "XDG_STATE_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=20,
        check=False,
    )
    assert (done.stdout, done.stderr) == ("", "")
    assert done.returncode == (0 if then == "answers" else 7)
    lines = (tmp_path / "fleet-tui" / "fleet-tui.log").read_text().splitlines()
    if then == "answers":
        waited = [f"n{n}" for n in range(11)]
        assert [line.rpartition(" ")[2] for line in lines if " x: " in line] == [*waited, "last"]
        assert "4 messages before this one lost: disk not responding" in lines[-2]


CLEARED = """
import logging, shutil, sys, time
from fleet_tui.config.log_file import log_to_file

path, log = log_to_file(False), logging.getLogger("x")
log.warning("before")
while not (path.exists() and "before" in path.read_text()):
    time.sleep(0.01)
shutil.rmtree(path.parent)
log.warning("after")
"""


def test_the_log_goes_on_where_its_folder_was_removed(tmp_path: Path) -> None:
    env = {**os.environ, "XDG_STATE_HOME": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", CLEARED], env=env, capture_output=True, timeout=20, check=False
    )
    log = tmp_path / "fleet-tui" / "fleet-tui.log"
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    assert log.read_text().endswith("WARNING x: after\n") and log.stat().st_mode & 0o777 == 0o600


@two_users
@pytest.mark.parametrize("name", ["audit.jsonl", "fleet-tui.log"])
def test_nothing_is_written_where_others_can_lay_links(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    state, mine = tmp_path / "fleet-tui", tmp_path / "mine"
    assert state_folder() == state and state_problem() == ""
    mine.write_text("mine")
    state.mkdir()
    (state / name).symlink_to(mine)
    state.chmod(0o777)
    assert state_problem() == (
        f"nothing is kept, no log, no audit log: {state} is writable by everyone: chmod o-w {state}"
    )
    with auditing(state_folder(), Config(), Store(fleet(1))) as audit:
        audit.log_console("said", "a word")
    assert mine.read_text() == "mine" and list(state.iterdir()) == [state / name]
