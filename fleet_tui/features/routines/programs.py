"""Programs of a routine: found before it starts, run in a thread, ended with it."""

import asyncio
import os
import shutil
import threading
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from fleet_tui.config.withholding import doubt_of_command
from fleet_tui.features.routines.blocks import RunBlock
from fleet_tui.features.routines.lane import ProgramEnded
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.programs.session_state import exit_text
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

ROBOT = "FLEET_TUI_ROBOT"
"""The variable with the name of the robot."""
JOIN = 1.0
"""Maximum seconds to wait for a program that was ended."""
LONGEST_END = 200
"""Characters of a program's output that are told."""


def program_path(folder: Path, word: str) -> str:
    """Return the path of a program: beside the routine if it is there or has a /, else from PATH; empty if it
    is not found or not executable."""
    beside = folder / word
    if "\0" in word:
        return ""
    if "/" in word or beside.is_file():
        return str(beside) if os.access(beside, os.X_OK) and beside.is_file() else ""
    return shutil.which(word) or ""


def program_problem(folder: Path, arguments: Sequence[str]) -> str:
    """Return the reason that a program can't be run, empty if it can."""
    word = arguments[0]
    if program_path(folder, word):
        return doubt_of_command(arguments, folder)
    if "\0" not in word and (folder / word).is_file():
        return Message(
            "{word}: not executable by this user: run chmod +x {folder}", word=word, folder=folder / word
        )
    return Message(
        "{program}: not found in {folder}, nor on PATH: correct the name",
        program=truncate(word, 80),
        folder=folder,
    )


class ProgramRun:
    """A program that runs; `ended` is its end, None before."""

    def __init__(self, folder: Path, block: RunBlock, robot: str) -> None:
        path = program_path(folder, block.arguments[0]) or block.arguments[0]
        self.ended: ProgramEnded | None = None
        arguments = [path, *block.arguments[1:]]
        self._within = block.within
        self._loop = asyncio.new_event_loop()
        process = _run_safe(arguments, block.within, {**os.environ, ROBOT: robot}, folder)
        self._task = self._loop.create_task(process)
        self._thread = threading.Thread(target=self._run, name="fleet-tui-program", daemon=True)
        self._thread.start()

    def _run(self) -> None:
        try:
            self.ended = _outcome(self._loop.run_until_complete(self._task), self._within)
        except asyncio.CancelledError:
            self.ended = ProgramEnded(False, Message("ended by a person"))
        finally:
            self._loop.close()

    def end(self) -> None:
        with suppress(RuntimeError):  # it has ended, and its loop is closed
            self._loop.call_soon_threadsafe(self._task.cancel)

    def join(self) -> None:
        """Wait a moment for the end."""
        self._thread.join(JOIN)


async def _run_safe(
    arguments: Sequence[str], within: float, environment: Mapping[str, str], folder: Path
) -> EndedProcess:
    """Run a program, unless somebody else could have written it: it may be a new one since the check."""
    if found := doubt_of_command(arguments, folder):
        return EndedProcess(None, problem=found)
    return await run(arguments, within, environment, folder)


def _outcome(process: EndedProcess, within: float) -> ProgramEnded:
    """Return the outcome, with the last line of the output."""
    lines = [line for line in process.output.splitlines() if line.strip()]
    last = truncate(sanitize(lines[-1].strip()), LONGEST_END) if lines else ""
    if process.is_late:
        reason: Message = Message("not ended within {within} s", within=f"{within:.0f}")
    else:
        reason = process.problem or (EMPTY if process.code is None else exit_text(process.code))
    return ProgramEnded(
        process.code == 0, Message("{reason}: {last}", reason=reason, last=last) if last else reason
    )
