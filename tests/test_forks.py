"""Tests side by side in forks: each ends with what it gave, also if its process ends."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
TESTS = """
import os
import pytest

@pytest.mark.parametrize("number", range(6))
def test_it(number, tmp_path):
    if number == 1:
        os._exit(3)
    if number == 2:
        pytest.skip("not here")
    print("said by", number)
    assert number != 4
"""


SHARING = """
import os
import pytest

pytestmark = pytest.mark.one_fork
RUN = []

@pytest.mark.parametrize("number", range(99))
def test_it(number):
    if number == 1:
        os._exit(3)
    RUN.append(number)
    assert number != 98 or RUN == list(range(2, 99))
"""


def run_of(folder: Path, tests: str) -> "subprocess.CompletedProcess[str]":
    (folder / "test_some.py").write_text(tests)
    (folder / "pytest.ini").write_text("[pytest]\nmarkers = one_fork\n")
    return subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "tests.support.forks", "--forks", "2", "test_some.py"],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "200"},
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_failure_and_a_process_that_ends_are_told_and_all_others_run(tmp_path: Path) -> None:
    run = run_of(tmp_path, TESTS)
    assert run.returncode == 1
    assert "FAILED test_some.py::test_it[1] - the process ended in this test, with 3\n" in run.stdout
    assert "FAILED test_some.py::test_it[4] - assert 4 != 4\n" in run.stdout
    assert "said by 4\n" in run.stdout and "said by 5" not in run.stdout
    assert "2 failed, 3 passed, 1 skipped" in run.stdout


def test_what_shares_a_dear_start_runs_in_one_fork_and_goes_on_in_one_more_after_its_end(
    tmp_path: Path,
) -> None:
    run = run_of(tmp_path, SHARING)
    assert "FAILED test_some.py::test_it[1] - the process ended in this test, with 3\n" in run.stdout
    assert "1 failed, 98 passed" in run.stdout
