"""Looks at a program: is it running, since when, and if that is unknown, why."""

import asyncio
import time
from collections.abc import Mapping
from datetime import MAXYEAR, MINYEAR, UTC, datetime
from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.programs import arguments
from fleet_tui.programs.process import EndedProcess, run
from fleet_tui.programs.reasons import NOT_FOUND, SSH_FAILED, failure, has_no_systemd, last_line
from fleet_tui.programs.session_state import session_status
from fleet_tui.text.language import EMPTY, N_, Message, verbatim
from fleet_tui.text.limits import truncate

LOOK_WITHIN = 8.0
"""Seconds until a look is given up: more than ssh takes to give up a host."""
_CANNOT_TELL = (4, 126, NOT_FOUND)
"""Exit codes by which a `status` tells nothing: LSB's unknown, and those of a program that can't be run."""


MOST_DEPENDENTS = 50
_STATES = {
    "active": ProgramState.RUNNING,
    "reloading": ProgramState.RUNNING,
    "activating": ProgramState.STARTING,
    "deactivating": ProgramState.STOPPING,
    "inactive": ProgramState.STOPPED,
    "failed": ProgramState.FAILED,
}
_RESULTS = {
    "exit-code": N_("exit status {status}"),
    "signal": N_("killed by signal {status}"),
    "core-dump": N_("crashed with signal {status}"),
    "timeout": N_("ended after its time limit"),
    "oom-kill": N_("killed for lack of memory"),
    "start-limit-hit": N_("started too often: systemd gave up"),
}


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


def unit_status(output: str, unit: str, at: float) -> ProgramStatus | None:
    """Return the state of a unit, None if the output is none of `systemctl show`."""
    found = dict(line.split("=", 1) for line in output.splitlines() if "=" in line)
    state = _STATES.get(found.get("ActiveState", ""))
    if state is None:
        return None
    if found.get("LoadState") == "not-found" and state is ProgramState.STOPPED:
        return ProgramStatus(
            ProgramState.UNKNOWN, at, detail=Message("no unit {unit}: check its name, and `user`", unit=unit)
        )
    return ProgramStatus(
        state,
        at,
        _seconds(found.get("StateChangeTimestamp", "")),
        _count(found.get("NRestarts", "")),
        found.get("InvocationID", ""),
        tuple(_dependents(found)),
        _detail(state, found),
    )


def _detail(state: ProgramState, found: Mapping[str, str]) -> Message:
    if state is ProgramState.FAILED:
        result = found.get("Result", "")
        if result in _RESULTS:
            return truncate(Message(_RESULTS[result], status=found.get("ExecMainStatus", "?")))
        return verbatim(truncate(result))
    if found.get("LoadState") in ("masked", "bad-setting", "error"):
        return Message("its unit file is {state}", state=found["LoadState"])
    sub = found.get("SubState", "")
    return (
        verbatim(truncate(sub)) if sub in ("auto-restart", "exited", "start-pre", "stop-sigterm") else EMPTY
    )


def _dependents(found: Mapping[str, str]) -> list[str]:
    units = [unit for key in ("RequiredBy", "BoundBy", "ConsistsOf") for unit in found.get(key, "").split()]
    return list(dict.fromkeys(map(truncate, units)))[:MOST_DEPENDENTS]


def _seconds(text: str) -> float | None:
    """Return a time as systemctl writes it, `Mon 2024-05-06 08:00:00 UTC`, in Unix seconds."""
    try:
        _, date, time, *_ = text.split()
        found = datetime.strptime(f"{date} {time}", "%Y-%m-%d %H:%M:%S").replace(tzinfo=UTC)
    except ValueError:
        return None
    # A day from either end of the calendar there is no local time.
    return found.timestamp() if MINYEAR < found.year < MAXYEAR else None


def _count(text: str) -> int | None:
    return int(text) if text.isdecimal() and len(text) < 10 else None
