"""Opens the recording of a past moment, in the place of the console until it is closed."""

import math
import shlex
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path

from fleet_tui.records.recording.covering import recording_at
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console

BEFORE = 10.0
"""Seconds before the moment from which it is played: what led to it."""


class PastReplay:
    """`run` gives the terminal to a command until it ends, and returns a reason if it can't; `loss` returns
    why the console can't be left alone now, empty if it can."""

    def __init__(
        self,
        console: Console,
        folder: Path,
        loss: Callable[[], Message],
        run: Callable[[Sequence[str]], Message],
    ) -> None:
        self._files = console.files
        self._folder = folder
        self._loss = loss
        self._run = run

    def find(self, at: float) -> tuple[Path, float] | None:
        """Return the recording that covers a Unix second, and when it begins; in a thread, a disk may be
        slow."""
        recordings = self._files.recordings
        running = recordings.recorder.paths if recordings is not None and recordings.recorder else []
        recent = recordings.recent() if recordings is not None else []
        return recording_at(self._folder, at, [*running, *recent])

    def open(self, found: tuple[Path, float] | None, at: float) -> Message:
        """Open it shortly before that second; return what to say, empty once it was seen."""
        if found is None:
            return Message(
                "no recording covers this moment: `record` in : starts one, the last minutes are always kept"
            )
        path, begun = found
        start = datetime.fromtimestamp(math.ceil(max(begun, at - BEFORE))).astimezone().replace(tzinfo=None)
        arguments = ["replay", str(path), "--at", start.isoformat(timespec="seconds")]
        if loss := self._loss():
            return Message(
                "{loss}: in another terminal: {command}",
                loss=loss,
                command=shlex.join(["fleet-tui", *arguments]),
            )
        return self._run([sys.executable, "-P", "-m", "fleet_tui", *arguments])


def run_in_terminal(command: Sequence[str]) -> Message:
    """Run a command with this terminal; return what to say if it failed, else nothing. Links, audit log and
    history go on in their threads."""
    # Ctrl-C in this terminal is for the command: until that reads keys, it would end the console as well.
    # A handler, unlike SIG_IGN, is not inherited.
    before = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        done = subprocess.run(command, check=False)
    finally:
        signal.signal(signal.SIGINT, before)
    said = shlex.join(["fleet-tui", *command[3:]])
    return (
        Message("exit status {code}: {text}", code=done.returncode, text=said) if done.returncode else EMPTY
    )
