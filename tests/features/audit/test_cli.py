"""`fleet-tui audit`: the log without a console."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.records.audit.log import encode
from tests.support.records import record


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """A log of two records, the second one hostile and refused, and something that is none."""
    path = tmp_path / "fleet-tui" / "audit.jsonl"
    path.parent.mkdir()
    odd = record("=\x1b[2Jx", change="refused", robot="robot_1")
    path.write_bytes(encode(record("ok")) + b"rubbish\n" + encode(odd))
    return path


def audit(log: Path, *args: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "fleet_tui", "audit", *args],
        env={**os.environ, "XDG_STATE_HOME": str(log.parent.parent)},
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_newest_first_and_nothing_that_acts_on_the_terminal(log: Path) -> None:
    done = audit(log)
    assert done.returncode == 0
    one, two = done.stdout.splitlines()
    assert one.endswith("ana robot_1 pause: refused (=␛[2Jx)") and two.endswith("robot_0 pause: sent (ok)")
    assert done.stderr == f"{log}: 1 unreadable line\n"


def test_by_robot_word_and_time(log: Path) -> None:
    assert "robot_1" not in audit(log, "--robot", "robot_0").stdout
    assert audit(log, "outcome:refused").stdout.count("\n") == 1
    assert "no matching record" in audit(log, "--since", "1h").stderr
    assert "no matching record" in audit(log, "--demo").stderr


def test_as_csv(log: Path) -> None:
    rows = list(csv.DictReader(audit(log, "--csv").stdout.splitlines()))
    assert [row["words"] for row in rows] == ["'=␛[2Jx", "ok"]


def test_a_time_that_is_none(log: Path) -> None:
    done = audit(log, "--since", "2x")
    assert done.returncode == 2 and "'2x' is not a time: use 30m" in done.stderr


def test_a_log_that_can_not_be_read(tmp_path: Path) -> None:
    log = tmp_path / "fleet-tui" / "audit.jsonl"
    log.mkdir(parents=True)
    done = audit(log)
    assert done.returncode == 1 and "Is a directory" in done.stderr and "Traceback" not in done.stderr
