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
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import msgspec

from fleet_tui import __version__
from fleet_tui.audit.entries import Origin, alarm_records, closing_records, command_records
from fleet_tui.audit.file import FILE_NAME, AuditFile
from fleet_tui.config.schema import Config
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.store import Store
from fleet_tui.text.sanitize import sanitize

LOG = logging.getLogger(__name__)

# Records that wait for a writable disk, and seconds between two attempts.
WAITING, RETRY = 10_000, 1.0
# Seconds in which the disk writes no line until it hangs, and in which it has not written all; only those
# count in which this process and the writing thread could run.
PATIENCE, LONGEST = 0.05, 0.5
# Seconds of a look, and those by which it may be late in a process that can run.
LOOK, ON_TIME = 0.005, 0.005
# Seconds that alarms, which nothing is sent after, wait for a slow disk in each RETRY.
SLOW_TOGETHER = 0.1
# Seconds without a written line after which an unresponsive disk is given up at the end.
LAST_CHANCE = 0.5

HANGS = "disk not responding"


def encode(record: AuditRecord) -> bytes:
    """Return a record as a line. Non-ASCII is escaped: no text from outside affects a terminal that shows the
    file."""
    return json.dumps(msgspec.to_builtins(record), separators=(",", ":")).encode() + b"\n"


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

    def __init__(self, file: AuditFile, origin: Origin) -> None:
        self.file, self.origin = file, origin
        self._waiting: deque[bytes] = deque()
        self._taken = self._done = self._lost = 0
        """Numbers of records: taken; of these written or dropped; lost without being counted as taken."""
        self._problem = ""
        self._is_writing = self._hangs = False
        """Whether a line has been handed to the disk, and whether that does not respond."""
        self._slow, self._slow_since = 0.0, 0.0
        self._closed = False
        self._watched: FleetState | None = None
        """The newest state whose changes are in the log."""
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._work, name="fleet-tui-audit", daemon=True)
        self._thread.start()

    @property
    def problem(self) -> str:
        """Return the reason that lines are not written now."""
        return self._problem or (HANGS if self._hangs else "")

    @property
    def notes(self) -> list[str]:
        """Return notes on the log for the operator; empty while all is written."""
        if problem := self.problem:
            return [f"audit: not written: {problem}"]
        return [f"audit: {self.file.warning}"] if self.file.warning else []

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
        done = -1
        while self._thread.is_alive() and done < self._done:
            done = self._done
            self._thread.join(LAST_CHANCE)
        return self._taken - self._done + self._lost

    def _of_console(self, change: str, words: str) -> AuditRecord:
        return self.origin.record(time.time(), kind="console", what="console", change=change, words=words)

    def _add(self, records: Iterable[AuditRecord]) -> None:
        if self._closed:
            return
        try:
            for record in records:
                self._append(encode(record))
        except Exception:
            # Whatever fails here, dispatch continues.
            LOG.exception("audit")
            self._lost += 1
        self._changed.notify_all()

    def _append(self, line: bytes) -> None:
        if len(self._waiting) >= WAITING:
            self._waiting.popleft()
            self._lost += 1
            self._done += 1
        self._waiting.append(line)
        self._taken += 1

    def _wait(self, is_urgent: bool) -> None:
        """Wait until everything is written, or the disk does not respond: a command is sent after this."""
        began = time.monotonic()
        if began > self._slow_since + RETRY:
            self._slow, self._slow_since = 0.0, began
        if self.problem or (not is_urgent and self._slow > SLOW_TOGETHER):
            return
        done, idle, longest = self._done, 0.0, 0.0
        while self._done != self._taken and not self._problem and self._thread.is_alive():
            look = time.monotonic()
            self._changed.wait(LOOK)
            took = time.monotonic() - look
            if self._done != done:
                done, idle = self._done, 0.0
            # A late look tells of a busy machine; so does a line that is not handed to the disk yet.
            elif self._is_writing and took < LOOK + ON_TIME:
                idle += took
            longest += took if took < LOOK + ON_TIME else 0.0
            if (idle > PATIENCE or longest > LONGEST) and self._is_writing and not self._wants_to_run():
                self._hangs = True
                LOG.error("audit: not written: %s: %s", self.file.path, HANGS)
                break
        self._slow += time.monotonic() - began

    def _wants_to_run(self) -> bool:
        """Tell whether the writing thread waits for a processor, not for the disk."""
        try:
            status = Path(f"/proc/self/task/{self._thread.native_id}/stat").read_text()
        except OSError:
            return False
        return status.rpartition(")")[2].split()[0] == "R"

    def _work(self) -> None:
        """Write line after line; on the log's own thread."""
        while (line := self._next()) is not None:
            try:
                self.file.append(line)
            except Exception as problem:  # noqa: BLE001  # whatever it is, the thread must not end by it
                if not self._failed(line, getattr(problem, "strerror", None) or repr(problem)):
                    break
            else:
                self._succeeded()
        self.file.close()

    def _next(self) -> bytes | None:
        """Return the next line, None after the last."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._closed)
            if not self._waiting:
                return None
            self._is_writing = True
            return self._waiting.popleft()

    def _succeeded(self) -> None:
        with self._changed:
            self._is_writing = self._hangs = False
            self._done += 1
            if not self._waiting:
                self._problem = ""
                if self._lost:
                    words = f"{self._lost} records before this one were not written"
                    self._append(encode(self._of_console("lost", words)))
                    self._lost = 0
            self._changed.notify_all()

    def _failed(self, line: bytes, problem: str) -> bool:
        """Keep the line, and wait for the next attempt; False if there will be none."""
        with self._changed:
            self._is_writing = self._hangs = False
            self._waiting.appendleft(line)
            if problem != self._problem:
                LOG.error("audit: not written: %s: %s", self.file.path, problem)
            self._problem = problem
            self._changed.notify_all()
            if self._closed:
                return False
            self._changed.wait_for(lambda: self._closed, RETRY)
            return True


@contextmanager
def auditing(folder: Path, config: Config, store: Store, demo: bool = False) -> Iterator[Audit]:
    """Keep the log of a console in the state folder while it runs. Lines missing at the end are reported on
    stderr, which must not be in use by a screen by then."""
    audit = Audit(AuditFile(folder / FILE_NAME), new_origin(config, demo))
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
