"""The state of a command in a session of its own, and how it is stopped."""

import os
import signal
from pathlib import Path

import msgspec

from fleet_tui.model.programs.program import ProgramState, ProgramStatus
from fleet_tui.programs.session import FILE_SUFFIX, RECORD
from fleet_tui.storage.handles import open_private
from fleet_tui.storage.lock import is_locked
from fleet_tui.text.language import EMPTY, Message


class SessionRecord(msgspec.Struct, frozen=True):
    """The record of a session in its file: `since` in Unix seconds, `code` once the command has ended."""

    pid: int
    instance: str
    since: float
    code: int | None = None
    stopped: bool = False


def session_status(folder: Path, name: str, at: float) -> ProgramStatus:
    """Return the state of a session; stopped if there was none."""
    record, is_running = _read(folder, name)
    if is_running:
        since, instance = (record.since, record.instance) if record else (None, "")
        return ProgramStatus(ProgramState.RUNNING, at, since, None, instance, has_systemd=False)
    if record is None or record.stopped or record.code == 0:
        since = record.since if record else None
        return ProgramStatus(ProgramState.STOPPED, at, since, has_systemd=False)
    detail = Message("killed with its session") if record.code is None else exit_text(record.code)
    return ProgramStatus(
        ProgramState.FAILED, at, record.since, None, record.instance, detail=detail, has_systemd=False
    )


def exit_text(code: int) -> Message:
    """Return an exit code in words; a negative one is a signal."""
    return (
        Message("killed by signal {code}", code=-code)
        if code < 0
        else Message("exit status {code}", code=code)
    )


def stop_session(folder: Path, name: str) -> Message:
    """Ask a session to stop its command. Returns the reason if that failed."""
    record, is_running = _read(folder, name)
    if not is_running or record is None:
        return Message("is not running")
    try:
        os.kill(record.pid, signal.SIGTERM)
    except OSError as problem:
        return Message("can't be stopped: {strerror}", strerror=problem.strerror)
    return EMPTY


def _read(folder: Path, name: str) -> tuple[SessionRecord | None, bool]:
    """Return the record of a session, and whether its command runs."""
    try:
        file = open_private(folder / f"{name}{FILE_SUFFIX}", os.O_RDONLY)
    except OSError:
        return None, False
    is_running = is_locked(file)
    try:
        return msgspec.json.decode(os.pread(file, RECORD, 0), type=SessionRecord), is_running
    except (msgspec.MsgspecError, UnicodeError, OSError):
        return None, is_running
    finally:
        os.close(file)
