"""Looks at all programs again and again, while somebody wants to see them."""

import asyncio
import logging
import time
from collections.abc import Sequence
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramRow, ProgramState, ProgramStatus
from fleet_tui.programs.status import look
from fleet_tui.text.language import Message

LOG = logging.getLogger(__name__)
EVERY = 2.0
EVERY_REMOTE = 5.0
"""Seconds between two looks at a program of this machine, and of another host."""
PER_PROGRAM = 0.1
"""Seconds between looks at two programs, on average: a hundred of them must not load the machine."""


class ProgramWatch:
    """`rows` has the newest look at each program. Each host has a task of its own, so that one that hangs
    delays no other, and so has each program of this machine."""

    def __init__(self, programs: Sequence[ProgramEntry], folder: Path) -> None:
        self.programs = {program.name: program for program in programs}
        self.rows = {one.name: ProgramRow(one.name, one.host, tuple(one.needs)) for one in programs}
        self.folder = folder
        self._tasks: list[asyncio.Task[None]] = []

    def open(self) -> None:
        """Start to look. Needs a running loop."""
        groups: dict[tuple[str, str], list[ProgramEntry]] = {}
        for one in self.programs.values():
            groups.setdefault((one.host, "" if one.host else one.name), []).append(one)
        if not self._tasks:
            self._tasks = [asyncio.ensure_future(self._watch(group)) for group in groups.values()]

    def close(self) -> None:
        """Stop looking."""
        for task in self._tasks:
            task.cancel()
        self._tasks = []

    def set_pending(self, name: str, verb: Message) -> None:
        """Note the change that is under way, none if it has ended."""
        self.rows[name] = replace(self.rows[name], pending=verb)

    def put(self, name: str, status: ProgramStatus) -> None:
        """Take the newest look at a program."""
        known = self.rows[name].last_known if status.state is ProgramState.UNKNOWN else status
        self.rows[name] = replace(self.rows[name], status=status, last_known=known)

    async def look(self, name: str) -> None:
        self.put(name, await look(self.programs[name], self.folder))

    async def _watch(self, group: Sequence[ProgramEntry]) -> None:
        every = max(EVERY_REMOTE if group[0].host else EVERY, PER_PROGRAM * len(self.programs))
        while True:
            for program in group:
                try:
                    await self.look(program.name)
                except Exception as problem:
                    LOG.exception("program %s", program.name)
                    fault = Message("internal error: {problem} (details in the log file)", problem=problem)
                    self.put(
                        program.name, ProgramStatus(ProgramState.UNKNOWN, time.monotonic(), detail=fault)
                    )
            await asyncio.sleep(every)
