"""The audit log of one console: every change of a command or an alarm becomes a line in a file.

It watches the store, so a command's line is written before the command is sent, however busy the machine is,
unless the disk hangs. It never raises: lines that can't be written are kept, reported on the screen, and
written later.
"""

import getpass
import itertools
import json
import logging
import os
import secrets
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import msgspec

from fleet_tui import __version__
from fleet_tui.config.schema import Config
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin, alarm_records, closing_records, command_records
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.state.store import Store
from fleet_tui.storage.line_file import LineFile
from fleet_tui.storage.worker import Worker
from fleet_tui.storage.write_queue import WriteQueue
from fleet_tui.text.language import Message, in_english
from fleet_tui.text.sanitize import sanitize

LOG = logging.getLogger(__name__)

# Records that wait for a writable disk, and seconds between two attempts.
WAITING = 10_000
RETRY = 1.0
# Seconds in which the disk writes no line until it hangs, and in which it has not written all; only those
# count in which this process and the writing thread could run.
PATIENCE = 0.05
LONGEST = 0.5
# Seconds of a look, and those by which it may be late in a process that can run.
LOOK = 0.005
ON_TIME = 0.005
# Seconds that alarms, which nothing is sent after, wait for a slow disk in each RETRY.
SLOW_TOGETHER = 0.1
# Seconds without a written line after which an unresponsive disk is given up at the end.
LAST_CHANCE = 0.5

HANGS = "disk not responding"


def encode(record: AuditRecord) -> bytes:
    """Return a record as a line. Non-ASCII is escaped: no text from outside affects a terminal that shows the
    file."""
    return (
        json.dumps(msgspec.to_builtins(record, enc_hook=in_english), separators=(",", ":")).encode() + b"\n"
    )


def operator_name(config: Config) -> str:
    """Return the operator's name: the config's, else the login name."""
    try:
        return config.operator.name or getpass.getuser()
    except (KeyError, OSError):
        return f"uid {os.getuid()}"


def console_name() -> str:
    """Return the name of this process in records: its host and its process id."""
    return f"{os.uname().nodename}:{os.getpid()}"


def new_origin(config: Config, demo: bool = False) -> Origin:
    """Return the author of this process's records."""
    return Origin(operator_name(config), console_name(), secrets.token_hex(4), demo)


class Audit:
    """Writes the log: callable from any thread, writing in its own, since a disk may hang."""

    def __init__(self, file: LineFile, origin: Origin) -> None:
        self.file = file
        self.origin = origin
        self._waiting = WriteQueue[bytes](WAITING)
        self._unread = 0
        """Changes of which no line could be made."""
        self._written = 0
        self._problem = ""
        self._is_writing = False
        """Whether a line has been handed to the disk."""
        self._hangs = False
        self._closed = False
        self._slow = 0.0
        self._slow_since = 0.0
        self._watched: FleetState | None = None
        """The newest state whose changes are in the log."""
        self._changed = threading.Condition()
        self._worker = Worker("audit", self._write, None, self._end)
        self._worker.start()

    @property
    def problem(self) -> str:
        """Return the reason that lines are not written now."""
        return self._problem or (HANGS if self._hangs else "")

    @property
    def notes(self) -> list[Message]:
        """Return notes on the log for the operator; empty while all is written."""
        if problem := self.problem:
            return [Message("audit: not written: {problem}", problem=problem)]
        return [Message("audit: {warning}", warning=self.file.warning)] if self.file.warning else []

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Write the changes from one state to the next."""
        with self._changed:
            is_urgent = self._write_changes(before, after)
            self._wait(is_urgent)

    def _write_changes(self, before: FleetState, after: FleetState) -> bool:
        """Tell whether changes of commands are among them."""
        now, wall = time.monotonic(), time.time()
        commands = list(command_records(self.origin, before, after, lambda at: wall - (now - at)))
        alarms = alarm_records(self.origin, before, after, wall)
        self._add(itertools.chain(commands, alarms))
        self._watched = after
        return bool(commands)

    def log_console(self, change: str, words: str = "") -> None:
        """Write an event of the console itself."""
        with self._changed:
            self._add([self._of_console(change, words)])
            self._wait(is_urgent=True)

    def close(self, state: FleetState) -> int:
        """Write the last record of every open command. Returns the number of records that could not be
        written."""
        with self._changed:
            if self._watched is not None and state.now >= self._watched.now:
                # Who waits for a stage sees it in the state before the log's watcher does.
                self._write_changes(self._watched, state)
            self._add(closing_records(self.origin, self._watched or state, time.time()))
            self._add([self._of_console("closed", "")])
            self._closed = True
        written = -1
        while not self._worker.close(LAST_CHANCE) and written < self._written:
            written = self._written
        return self._lost + len(self._waiting) + self._is_writing

    @property
    def is_written(self) -> bool:
        """Tell whether no line is on its way."""
        return not self._waiting and not self._is_writing

    @property
    def _lost(self) -> int:
        return self._waiting.lost + self._unread

    def _of_console(self, change: str, words: str) -> AuditRecord:
        return self.origin.record(time.time(), kind="console", what="console", change=change, words=words)

    def _add(self, records: Iterable[AuditRecord]) -> None:
        if self._closed:
            return
        try:
            for record in records:
                self._waiting.append(encode(record))
        except Exception:
            # Whatever fails here, dispatch continues.
            LOG.exception("audit")
            self._unread += 1
        self._worker.wake()

    def _wait(self, is_urgent: bool) -> None:
        """Wait until everything is written, or the disk does not respond: a command is sent after this."""
        began = time.monotonic()
        if began > self._slow_since + RETRY:
            self._slow = 0.0
            self._slow_since = began
        if self.problem or (not is_urgent and self._slow > SLOW_TOGETHER):
            return
        written = self._written
        idle = longest = 0.0
        while not self.is_written and not self._problem and self._worker.is_running:
            look = time.monotonic()
            self._changed.wait(LOOK)
            took = time.monotonic() - look
            if self._written != written:
                written = self._written
                idle = 0.0
            # A late look tells of a busy machine, and so does a thread that could run.
            if took < LOOK + ON_TIME and not self._worker.waits_for_processor:
                longest += took
                # A line that is not handed to the disk yet is not the disk's.
                idle += took if self._is_writing else 0.0
            if self._is_writing and (idle > PATIENCE or longest > LONGEST):
                self._hangs = True
                LOG.error("audit: not written: %s: %s", self.file.path, HANGS)
                break
        self._slow += time.monotonic() - began

    def _write(self) -> None:
        """Write line after line; on the log's own thread."""
        while (line := self._next()) is not None:
            try:
                self.file.append(line)
            except Exception as problem:  # noqa: BLE001  # whatever it is, the line must be kept
                self._failed(line, getattr(problem, "strerror", None) or repr(problem))
                if self._worker.rest(RETRY):
                    break
            else:
                self._succeeded()

    def _end(self) -> None:
        self._write()
        self.file.close()

    def _next(self) -> bytes | None:
        """Return the next line, None if there is none."""
        with self._changed:
            if not self._waiting:
                return None
            self._is_writing = True
            return self._waiting.popleft()

    def _succeeded(self) -> None:
        with self._changed:
            self._is_writing = self._hangs = False
            self._written += 1
            if not self._waiting:
                self._problem = ""
                if self._lost:
                    words = f"{self._lost} records before this one were not written"
                    self._waiting.append(encode(self._of_console("lost", words)))
                    self._waiting.lost = self._unread = 0
            self._changed.notify_all()

    def _failed(self, line: bytes, problem: str) -> None:
        """Keep the line for the next attempt."""
        with self._changed:
            self._is_writing = self._hangs = False
            self._waiting.put_back(line)
            if problem != self._problem:
                LOG.error("audit: not written: %s: %s", self.file.path, problem)
            self._problem = problem
            self._changed.notify_all()


@contextmanager
def auditing(folder: Path, config: Config, store: Store, demo: bool = False) -> Iterator[Audit]:
    """Keep the log of a console in the state folder while it runs. Lines missing at the end are reported on
    stderr, which must not be in use by a screen by then."""
    audit = Audit(audit_file(folder / FILE_NAME), new_origin(config, demo))
    audit.log_console(
        "opened", f"fleet-tui {__version__}" + (", read-only" if config.operator.read_only else "")
    )
    store.watchers.append(audit.watch)
    try:
        yield audit
    finally:
        store.watchers.remove(audit.watch)
        missing = audit.close(store.state)
        if missing:
            _warn(f"audit: {missing} record{'s' * (missing != 1)} not written: {audit.problem}")


def _warn(text: str) -> None:
    LOG.error("%s", text)
    with suppress(OSError, ValueError):  # stderr may be gone
        sys.stderr.write(f"{sanitize(text)}\n")
