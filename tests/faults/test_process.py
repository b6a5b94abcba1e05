"""The process and its terminal: whatever ends it, it ends soon and leaves nothing behind."""

import os
import re
import shutil
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support import terminal_session as in_terminal_module
from tests.support.cli import config_file
from tests.support.fault_report import report
from tests.support.in_pty import serving
from tests.support.invariants import read
from tests.support.terminal_session import InTerminal, exists, in_terminal

RESTORED = "the shell, its terminal as before"
LINK_WITH_AGE = re.compile(r"ws://127\.0\.0\.1:\d+ \d+(\.\d)? s")


@pytest.fixture
def demo(tmp_path: Path) -> Iterator[InTerminal]:
    with in_terminal(tmp_path, "demo", "--robots", "2") as running:
        running.shows("robot_1")
        running.shows("●")
        yield running


def command(running: InTerminal) -> None:
    """Have a command under way: the log must have its end, or that its console was closed."""
    log = running.home / "state" / "fleet-tui" / "audit.jsonl"
    running.press("p")
    running.until(lambda: b'"change":"sent"' in log.read_bytes(), what="sent")


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGINT"])
def test_a_signal_ends_it(demo: InTerminal, name: str) -> None:
    simulator = demo.children()
    command(demo)
    demo.child.send_signal(signal.Signals[name])
    took = demo.ends()
    demo.until(demo.is_restored, what="the terminal restored")
    demo.until(lambda: not any(map(exists, simulator)), what="the simulator's end")
    assert simulator
    report(f"{name}", "sent to the process", RESTORED, took, None)


def test_ssh_gone(demo: InTerminal) -> None:
    """The other end of the terminal is closed: the kernel sends SIGHUP, reads and writes fail."""
    simulator = demo.children()
    command(demo)
    demo.hang_up()
    took = demo.ends()
    demo.until(lambda: not any(map(exists, simulator)), what="the simulator's end")
    report("SSH connection lost", "the terminal's other end closes", "-", took, None)


def test_a_terminal_of_another_session_goes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As under setsid: the kernel tells nobody, and reads find the end of the input, again and again."""
    monkeypatch.setattr(in_terminal_module, "_take_over", lambda *_: os.setsid())
    with in_terminal(tmp_path, "demo", "--robots", "2") as running:
        running.shows("robot_1")
        simulator = running.children()
        running.hang_up()
        took = running.ends()
        running.until(lambda: not any(map(exists, simulator)), what="the simulator's end")
        assert simulator
    report("terminal gone, no SIGHUP", "a terminal of another session; its other end closes", "-", took, None)


def test_killed(demo: InTerminal) -> None:
    simulator = demo.children()
    command(demo)
    demo.child.kill()
    demo.ends()
    took = demo.until(lambda: not any(map(exists, simulator)), what="the simulator's end")
    report("SIGKILL", "sent to the process", "no child is left", took, None)


def test_a_terminal_that_does_not_read_any_more(demo: InTerminal) -> None:
    """A frozen SSH client, or Ctrl-S: the process must end all the same."""
    command(demo)
    demo.reads.clear()
    demo.press("m")
    demo.resize(200, 60)
    time.sleep(0.5)  # what it still sends fills the terminal: of that nobody tells
    for width in range(100, 160):
        demo.resize(width, 40)
        time.sleep(0.02)  # as fast as a window is dragged
    demo.child.send_signal(signal.SIGTERM)
    took = demo.ends()
    report("terminal does not read", "the pty is not read; SIGTERM", "-", took, None)


def test_to_the_shell_and_back(demo: InTerminal) -> None:
    def state() -> str:
        return Path(f"/proc/{demo.child.pid}/stat").read_text().rpartition(")")[2].split()[0]

    demo.child.send_signal(signal.SIGTSTP)
    noticed = demo.until(lambda: state() == "T" and demo.is_restored(), what="stopped")
    demo.forget()
    demo.child.send_signal(signal.SIGCONT)
    healed = demo.until(lambda: "robot_1" in demo.text() and "floor_0" in demo.text(), what="the picture")
    report("SIGTSTP, fg", "sent to the process", RESTORED, noticed, healed)


STOPPED = 20.0 if "FLEET_TUI_FAULTS" in os.environ else 4.0
"""Seconds for which a console is stopped, four times as long as it waits for an answer."""


def test_stopped_while_the_answer_comes(tmp_path: Path) -> None:
    """Time in which it does not run is no time waited: nothing is missing, no robot is blamed."""
    with serving("fleet_tui", "sim", "--port", "0", "--stop-with-stdin", "--robots", "2") as (url, simulator):
        config = config_file(tmp_path, url, 2, 2)
        config.write_text(f"{config.read_text()}[alarms]\nno_answer_after = {STOPPED / 4}\n")
        with in_terminal(tmp_path, "--config", str(config)) as running:
            log = running.home / "state" / "fleet-tui" / "audit.jsonl"

            def changes(what: str) -> list[str]:
                return [record.change for record in read(log) if record.what == what]

            running.until(lambda: "robot_1" in running.text() and "●" in running.text(), what="a link")
            simulator.send_signal(signal.SIGSTOP)
            command(running)
            running.child.send_signal(signal.SIGSTOP)
            simulator.send_signal(signal.SIGCONT)
            time.sleep(STOPPED)  # the fault itself
            running.child.send_signal(signal.SIGCONT)
            noticed = running.until(lambda: "this console is " in running.text(), what="that it was stopped")
            running.until(lambda: "confirmed" in changes("pause"), what="the outcome")
            running.until(lambda: len(changes("behind")) == 2, what="the end of it")
            assert changes("pause") == ["checked", "sent", "accepted", "confirmed"]
            assert changes("offline") == []
            assert changes("behind") == ["raised", "returned, cleared"]
    seen = "`this console is 20 s behind`, an alarm; the outcome of its command, no robot offline"
    report("SIGSTOP for 20 s, SIGCONT", "sent to the process, before an answer comes", seen, noticed, None)


def test_resized_to_nothing_and_back_hundreds_of_times(demo: InTerminal) -> None:
    for _ in range(200):
        for size in ((1, 1), (120, 40)):
            demo.resize(*size)
            time.sleep(0.004)  # faster than it can paint, but each is seen
    demo.forget()
    demo.press("\x0c")
    healed = demo.until(lambda: "robot_1" in demo.text() and "floor_0" in demo.text(), what="the picture")
    assert demo.child.poll() is None and "Traceback" not in demo.text()
    report("resizing", "1 x 1 and back, 200 times in 2 s", "the correct picture", None, healed)


def pause(running: InTerminal) -> None:
    """A command works from its key to the robot's own word."""
    running.until(lambda: "robot_1" in running.text() and "●" in running.text(), what="a link")
    running.press("p")
    running.shows("paused")


def test_the_disk_is_full(tmp_path: Path) -> None:
    with in_terminal(tmp_path, "--debug", "demo", largest_file=1) as running:
        pause(running)
        running.shows("audit: not written")
        running.shows("last minutes not kept")
        running.press("q")
        running.ends()
        assert running.child.returncode == 0
        running.until(running.is_restored, what="the terminal restored")
        after = running.sent.rpartition(b"\x1b[?1049l")[2]
        assert re.search(rb"audit: \d+ records not written: File too large\r\n", after)
        assert b"Traceback" not in running.sent
    seen = "audit: not written; all else works; at the end stderr reports the number of lost records"
    report("disk full", "no file can grow", seen, None, None)


@pytest.mark.parametrize("state", ["/proc/nowhere", "/dev/null/x"])
def test_nothing_can_be_kept(tmp_path: Path, state: str) -> None:
    with in_terminal(tmp_path, "demo", XDG_STATE_HOME=state, HOME="/proc/nowhere") as running:
        running.shows(f"logging off: {state}/fleet-tui is not writable")
        pause(running)
        running.shows("audit: not written")
    report("no home", "a path that cannot be created", "logging off: ..., audit: not written", None, None)


@pytest.mark.parametrize("was_used", [False, True])
def test_the_home_is_read_only(tmp_path: Path, was_used: bool) -> None:
    state = tmp_path / "state"
    folder = state / "fleet-tui"
    if was_used:
        folder.mkdir(parents=True)
        for name in ("audit.jsonl", "fleet-tui.log"):
            (folder / name).touch(0o400)
        folder.chmod(0o500)
    else:
        state.mkdir(0o500)
    with in_terminal(tmp_path, "demo") as running:
        running.shows("logging off: ")
        pause(running)
        running.shows("audit: not written: Permission denied")
        for width in (80, 120):
            running.forget()
            running.resize(width, 24)
            running.until(lambda: LINK_WITH_AGE.search(running.text().partition("\n")[0]), what="the link")
    seen = "logging off: ..., audit: not written: Permission denied; the link and its age stay"
    report("read-only home", "folders without write permission", seen, None, None)


HANGING = """
import logging, os, time
real = os.write

def stuck(*_):
    while True:
        time.sleep(1)

def write(fd, data):
    return stuck() if os.readlink(f"/proc/self/fd/{fd}").endswith(".jsonl") else real(fd, data)

os.write = write
logging.FileHandler.flush = stuck
"""


def test_the_state_folders_disk_hangs(tmp_path: Path) -> None:
    """A network's file system whose server is gone: neither log holds the robots or the screen."""
    (tmp_path / "sitecustomize.py").write_text(HANGING)
    with in_terminal(tmp_path, "demo", PYTHONPATH=str(tmp_path)) as running:
        pause(running)
        running.shows("audit: not written: disk not responding")
        running.press("q")
        running.ends()
        assert running.child.returncode == 0
        running.until(running.is_restored, what="the terminal restored")
        running.shows("records not written: disk not responding")
    seen = "audit: not written: disk not responding; all else works"
    report("disk hangs", "no write to the state folder returns", seen, None, None)


def test_the_state_folder_goes_away(demo: InTerminal, tmp_path: Path) -> None:
    shutil.rmtree(tmp_path / "state")
    pause(demo)
    report("state folder removed", "while the console runs", "keeps working", None, None)


def test_two_consoles_on_one_state_folder(demo: InTerminal, tmp_path: Path) -> None:
    with in_terminal(tmp_path, "demo") as other:
        for console in (demo, other):
            pause(console)
        for console in (demo, other):
            console.press("q")
            console.ends()
    log = (tmp_path / "state" / "fleet-tui" / "fleet-tui.log").read_text()
    assert all(f" {console.child.pid} " in log for console in (demo, other))
    report("two consoles", "with one state folder", "both work; every line stays whole", None, None)


SLOW_LOOK_UP = """
import socket, time
real = socket.getaddrinfo
socket.getaddrinfo = lambda *a, **k: time.sleep(30) if a[0] == "slow.example" else real(*a, **k)
"""


@pytest.mark.parametrize("key", ["q", ""])
def test_a_name_that_is_looked_up_for_ever(tmp_path: Path, key: str) -> None:
    (tmp_path / "sitecustomize.py").write_text(SLOW_LOOK_UP)
    config = tmp_path / "config.toml"
    config.write_text(
        '[rosbridge]\nurl = "ws://slow.example:9090"\n[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'
    )
    with in_terminal(tmp_path, "--config", str(config), PYTHONPATH=str(tmp_path)) as running:
        running.shows("connecting")
        noticed = running.until(lambda: "connection timed out" in running.text())
        if key:
            running.press(key)
        else:
            running.child.send_signal(signal.SIGTERM)
        took = running.ends()
        assert running.is_restored()
    report("DNS hangs", "each lookup takes 30 s", "connection timed out", noticed, took)
