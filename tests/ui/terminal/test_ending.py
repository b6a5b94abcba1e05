"""Ends that nothing holds up: a process that hangs, and a terminal left as it was."""

import asyncio
import os
import pty
import signal
import sys
import termios
import threading
from collections.abc import Iterator

import pytest

from fleet_tui.ui.terminal import ending
from fleet_tui.ui.terminal.ending import end_within, leave_on_signals, terminal_restorer
from tests.support.polling import HANGS


class Pty:
    """A terminal, as standard output."""

    def __init__(self) -> None:
        self.far, near = pty.openpty()
        self.out = os.fdopen(near, "w")

    def read(self) -> bytes:
        return os.read(self.far, 10_000)


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Iterator[Pty]:
    terminal = Pty()
    monkeypatch.setattr(sys, "__stdout__", terminal.out)
    monkeypatch.setattr(threading, "excepthook", threading.excepthook)
    yield terminal
    terminal.out.close()


def test_a_process_that_hangs_is_restored_and_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    ended, done = list[object](), threading.Event()

    def exit_(code: int) -> None:
        ended.append(code)
        done.set()

    monkeypatch.setattr(os, "_exit", exit_)
    end_within(0.0, 143, lambda: ended.append("restored"))
    assert done.wait(10) and ended == ["restored", 143]


def test_the_terminal_gets_its_modes_and_its_first_screen_back(
    terminal: Pty, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdout", terminal.out)
    before = termios.tcgetattr(terminal.out)
    restore = terminal_restorer()
    changed = termios.tcgetattr(terminal.out)
    changed[3] &= ~(termios.ECHO | termios.ICANON)
    termios.tcsetattr(terminal.out, termios.TCSANOW, changed)
    restore()
    assert termios.tcgetattr(terminal.out) == before
    said = terminal.read()
    assert b"\x1b[?1049l" in said and said.endswith(b"\x1b[?25h")
    assert os.get_blocking(terminal.out.fileno())


def test_a_terminal_that_is_not_read_holds_up_no_restoring(
    terminal: Pty, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stdout", terminal.out)
    restore = terminal_restorer()
    os.set_blocking(terminal.out.fileno(), False)
    with pytest.raises(BlockingIOError):
        while True:
            os.write(terminal.out.fileno(), b"x" * 4096)
    restore()
    assert os.get_blocking(terminal.out.fileno())


def test_without_a_terminal_there_is_nothing_to_restore() -> None:
    terminal_restorer()()


@pytest.fixture
def usual_signals() -> Iterator[None]:
    numbers = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
    before = {number: signal.getsignal(number) for number in numbers}
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
async def test_a_signal_leaves_in_order_with_a_last_resort(
    number: int, terminal: Pty, usual_signals: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    resorts: list[tuple[float, int]] = []
    monkeypatch.setattr(ending, "end_within", lambda seconds, code, _restore: resorts.append((seconds, code)))
    left = asyncio.Event()
    leave_on_signals(asyncio.get_running_loop(), left.set, lambda: None)
    os.kill(os.getpid(), number)
    async with asyncio.timeout(HANGS):
        await left.wait()
    assert resorts == [(ending.PATIENCE, 128 + number)]


async def test_a_terminal_that_goes_away_is_a_hang_up(
    terminal: Pty, usual_signals: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    resorts: list[int] = []
    monkeypatch.setattr(ending, "end_within", lambda _seconds, code, _restore: resorts.append(code))
    left = asyncio.Event()
    leave_on_signals(asyncio.get_running_loop(), left.set, lambda: None)
    assert not left.is_set()
    os.close(terminal.far)
    async with asyncio.timeout(HANGS):
        await left.wait()
    assert resorts == [128 + signal.SIGHUP]
