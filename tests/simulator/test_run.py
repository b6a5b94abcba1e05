"""The simulator as a process: it comes, says where it is, and goes without a word."""

import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest

PROGRAM = """
from fleet_tui.simulator.run import run
run(1, 1, 0, 10.0, 1, lambda urls: print(*urls, flush=True), stop_with_stdin=True)
"""


@pytest.fixture
def process() -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("ws://127.0.0.1:")
        yield process
        process.kill()


@pytest.mark.parametrize(("number", "code"), [(signal.SIGTERM, 0), (signal.SIGINT, 130)])
def test_a_signal_ends_it_quietly(process: subprocess.Popen[str], number: int, code: int) -> None:
    process.send_signal(number)
    assert process.wait(10) == code
    assert process.stderr is not None
    assert process.stderr.read() == ""


def test_it_ends_with_its_parents_pipe(process: subprocess.Popen[str]) -> None:
    assert process.stdin is not None
    process.stdin.close()
    assert process.wait(10) == 0
    assert process.stderr is not None
    assert process.stderr.read() == ""
