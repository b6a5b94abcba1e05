"""Looks at a program: is it running, since when, and if that is unknown, why."""

import asyncio
import time
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.programs import arguments
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.programs.reasons import NOT_FOUND, SSH_FAILED, failure, has_no_systemd, last_line
from fleet_tui.programs.session_state import session_status
from fleet_tui.programs.unit_state import unit_status

LOOK_WITHIN = 8.0
"""Seconds until a look is given up: more than ssh takes to give up a host."""
_CANNOT_TELL = (4, 126, NOT_FOUND)
"""Exit codes by which a `status` tells nothing: LSB's unknown, and those of a program that can't be run."""


async def look(program: ProgramEntry, folder: Path) -> ProgramStatus:
    """Look at a program; `folder` has the sessions of this machine."""
    if program.status:
        return await _by_exit_code(program)
    if not program.is_kept or program.host:
        return await _by_systemd(program)
    session = await asyncio.to_thread(session_status, folder, program.name, time.monotonic())
    if session.state is ProgramState.RUNNING:
        return session
    found = await _by_systemd(program)
    return found if found.has_systemd else replace(session, at=found.at)


async def _by_exit_code(program: ProgramEntry) -> ProgramStatus:
    ended = await run(arguments.on_host(program, program.status), LOOK_WITHIN)
    at = time.monotonic()
    if ended.code == 0:
        return ProgramStatus(ProgramState.RUNNING, at)
    lost = program.host and ended.code == SSH_FAILED
    if ended.code is None or ended.code < 0 or ended.code in _CANNOT_TELL or lost:
        return ProgramStatus(ProgramState.UNKNOWN, at, detail=failure(program, ended))
    return ProgramStatus(ProgramState.STOPPED, at, detail=last_line(ended.output))


async def _by_systemd(program: ProgramEntry) -> ProgramStatus:
    ended = await run(arguments.show(program), LOOK_WITHIN)
    at = time.monotonic()
    found = unit_status(ended.output, arguments.unit_of(program), at) if ended.code == 0 else None
    if found is None:
        return _unknown(program, ended, at)
    if program.is_kept and found.state is ProgramState.UNKNOWN:
        # The unit of a command goes when it ends well.
        return ProgramStatus(ProgramState.STOPPED, at)
    return found


def _unknown(program: ProgramEntry, ended: EndedProcess, at: float) -> ProgramStatus:
    detail = failure(program, ended)
    return ProgramStatus(ProgramState.UNKNOWN, at, detail=detail, has_systemd=not has_no_systemd(ended))
