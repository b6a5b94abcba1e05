"""From a moment of the history into the recording that covers it."""

import math
import signal
import sys
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from fleet_tui.features.history.replaying import BEFORE, PastReplay, run_in_terminal
from fleet_tui.records.recording.indexing import header_of
from fleet_tui.text.language import EMPTY, Message
from tests.support.desk import Desk, ready
from tests.support.tapes import shift


def local(at: float) -> str:
    return datetime.fromtimestamp(at).isoformat(timespec="seconds")


def test_it_is_opened_shortly_before_the_moment_and_not_before_its_begin(tmp_path: Path) -> None:
    tape = tmp_path / "recordings" / "a.jsonl.gz"
    tape.parent.mkdir()
    shift(tape)
    begun, ran = header_of(tape).wall, list[Sequence[str]]()

    def run(command: Sequence[str]) -> Message:
        ran.append(command)
        return Message("closed")

    replaying = PastReplay(Desk(ready()).console(), tmp_path, lambda: EMPTY, run)
    found = replaying.find(begun + 1)
    assert found == (tape, begun) and replaying.find(begun - 100) is None
    assert replaying.open((tape, begun), begun + 100) == "closed"
    assert ran[0][:4] == [sys.executable, "-P", "-m", "fleet_tui"]
    assert ran[0][4:] == ["replay", str(tape), "--at", local(math.ceil(begun + 100 - BEFORE))]
    replaying.open((tape, begun), begun + 1)
    assert ran[1][-1] >= local(begun)


def test_a_console_that_can_not_be_left_alone_says_the_command(tmp_path: Path) -> None:
    def never(_command: Sequence[str]) -> Message:
        raise AssertionError

    replaying = PastReplay(Desk(ready()).console(), tmp_path, lambda: Message("a routine runs here"), never)
    said = replaying.open((tmp_path / "a b.jsonl", 0.0), 50.0)
    assert said.startswith("a routine runs here: in another terminal: fleet-tui replay '")
    assert replaying.open(None, 50.0).startswith("no recording covers this moment")


def test_a_failure_is_said_with_the_command() -> None:
    command = [sys.executable, "-c", "import sys; sys.exit(len(sys.argv) - 1)"]
    assert run_in_terminal(command) == ""
    assert run_in_terminal([*command, "a b"]) == "exit status 1: fleet-tui 'a b'"


def test_ctrl_c_ends_the_command_and_not_the_console() -> None:
    code = "import os, signal; os.kill(os.getppid(), signal.SIGINT); signal.raise_signal(signal.SIGINT)"
    before = signal.getsignal(signal.SIGINT)
    assert run_in_terminal([sys.executable, "-c", code]).startswith("exit status -2")
    assert signal.getsignal(signal.SIGINT) is before
