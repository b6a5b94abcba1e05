"""The newest lines of a log, followed within bounds, however fast it grows."""

import asyncio
import re
from collections import deque
from collections.abc import Sequence

from fleet_tui.programs.process import exit_code, not_started, running
from fleet_tui.programs.session_state import exit_text
from fleet_tui.text.language import EMPTY, Message

MOST_LINES = 2000
LONGEST_LINE = 1000
"""Characters of a line that are kept."""
BLOCK = 2**16
REST = 0.05
"""Seconds between two full blocks: a program that floods its log waits, not the console."""
_COLOURS = re.compile(r"\x1b\[[0-9;]*m")


class LogTail:
    """`lines` are the newest ones with their numbers, unsanitized; `note` says why no more come."""

    def __init__(self) -> None:
        self.lines: deque[tuple[int, str]] = deque(maxlen=MOST_LINES)
        self.note = EMPTY
        self.has_ended_well = False
        self._count = 0
        self._rest = b""

    async def follow(self, arguments: Sequence[str]) -> None:
        """Read the output of a process until it ends, or this is cancelled."""
        try:
            async with running(arguments) as process:
                assert process.stdout is not None
                while block := await process.stdout.read(BLOCK):
                    self.put(block)
                    if len(block) == BLOCK:
                        await asyncio.sleep(REST)
                self.put(b"\n" if self._rest else b"")
                code = await exit_code(process)
                self.has_ended_well = code == 0
                self.note = Message("the log ended: {exit_text}", exit_text=exit_text(code))
        except (OSError, ValueError) as problem:
            self.note = not_started(arguments[0], problem)

    def put(self, block: bytes) -> None:
        """Add a block of bytes; half a line waits for its rest."""
        *whole, rest = (self._rest + block).split(b"\n")
        for line in whole[-MOST_LINES:]:
            self._count += 1
            self.lines.append((self._count, _text(line)))
        # Beyond what is kept of a line nothing of it is needed, however long it becomes.
        self._rest = rest[: 4 * LONGEST_LINE + 1]


def _text(line: bytes) -> str:
    text = _COLOURS.sub("", line[: 4 * LONGEST_LINE + 1].decode("utf-8", "replace")).rstrip("\r")
    return text if len(text) <= LONGEST_LINE else f"{text[:LONGEST_LINE]}…"
