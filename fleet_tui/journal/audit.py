"""The audit log of one console: every change of a command or an alarm becomes a line in a file.

It watches the store, so a command's line is written before the command is sent. It never raises and
never waits: what can't be written is kept, said on the screen, and written when that is possible again.
"""

import getpass
import itertools
import json
import logging
import os
import secrets
import threading
import time
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec

from fleet_tui import __version__
from fleet_tui.config.schema import Config
from fleet_tui.journal.audit_file import FILE_NAME, AuditFile
from fleet_tui.journal.entries import Origin, alarm_records, closing_records, command_records
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.store import Store

LOG = logging.getLogger(__name__)

# Records that wait for a disk that takes them, how many go at a time, and seconds between two tries.
WAITING, AT_ONCE, RETRY = 10_000, 200, 1.0


def encode(record: AuditRecord) -> bytes:
    """A record as a line. All but ASCII is escaped: no text from outside acts on who looks at the file."""
    return json.dumps(msgspec.to_builtins(record), separators=(",", ":")).encode() + b"\n"


def operator_name(config: Config) -> str:
    """Who commands: the config's name, else the login name."""
    try:
        return config.operator.name or getpass.getuser()
    except (KeyError, OSError):
        return f"uid {os.getuid()}"


class Audit:
    """Writes the log. The writer's thread calls `watch`; any other may call the rest."""

    def __init__(self, file: AuditFile, origin: Origin) -> None:
        self.file, self.origin = file, origin
        self._waiting: deque[bytes] = deque()
        self._lost = 0
        self._problem = ""
        self._retry_at = 0.0
        self._closed = False
        self._lock = threading.Lock()

    @property
    def notes(self) -> list[str]:
        """What the operator must know of the log; nothing while it is written as it should be."""
        if self._problem:
            return [f"audit: not written: {self._problem}"]
        return [f"audit: {self.file.warning}"] if self.file.warning else []

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Write what changed from one state to the next."""
        now, wall = time.monotonic(), time.time()
        commands = command_records(self.origin, before, after, lambda at: wall - (now - at))
        self._take(itertools.chain(commands, alarm_records(self.origin, before, after, wall)))

    def tell(self, change: str, words: str = "") -> None:
        """Write what happened to the console itself."""
        self._take(
            [self.origin.record(time.time(), kind="console", what="console", change=change, words=words)]
        )

    def retry(self) -> None:
        """Write what could not be written before, if it is time to try again."""
        if self._waiting:
            self._take([])

    def close(self, state: FleetState) -> int:
        """Write the last word on every open command. Returns how many records could not be written."""
        self._take(closing_records(self.origin, state, time.time()))
        self.tell("closed")
        with self._lock:
            self._closed = True
            if self._waiting:
                self._write(len(self._waiting))
            self.file.close()
        return len(self._waiting) + self._lost

    def _take(self, records: Iterable[AuditRecord]) -> None:
        with self._lock:
            if self._closed:
                return
            try:
                for record in records:
                    self._keep(encode(record))
                if not self._problem:
                    self._write(len(self._waiting))
                elif self._waiting and time.monotonic() >= self._retry_at:
                    self._write(AT_ONCE)
            except Exception:
                # Whatever is wrong with us, dispatch goes on.
                LOG.exception("audit")
                self._lost += 1

    def _keep(self, line: bytes) -> None:
        if len(self._waiting) >= WAITING:
            self._waiting.popleft()
            self._lost += 1
        self._waiting.append(line)

    def _write(self, at_most: int) -> None:
        try:
            for _ in range(min(at_most, len(self._waiting))):
                self.file.append(self._waiting[0])
                self._waiting.popleft()
            if self._lost and not self._waiting:
                self._tell_what_is_lost()
        except OSError as problem:
            self._fail(problem.strerror or str(problem))
        else:
            self._problem = self._problem if self._waiting else ""

    def _tell_what_is_lost(self) -> None:
        words = f"{self._lost} records before this one could not be written"
        record = self.origin.record(time.time(), kind="console", what="console", change="lost", words=words)
        self.file.append(encode(record))
        self._lost = 0

    def _fail(self, problem: str) -> None:
        if problem != self._problem:
            LOG.error("audit: not written: %s: %s", self.file.path, problem)
        self._problem = problem
        self._retry_at = time.monotonic() + RETRY


@contextmanager
def auditing(folder: Path, config: Config, store: Store, demo: bool = False) -> Iterator[Audit]:
    """Keep the log of a console in the state folder while it runs."""
    origin = Origin(operator_name(config), f"{os.uname().nodename}:{os.getpid()}", secrets.token_hex(4), demo)
    audit = Audit(AuditFile(folder / FILE_NAME), origin)
    audit.tell("opened", f"fleet-tui {__version__}" + (", read-only" if config.operator.read_only else ""))
    store.watchers.append(audit.watch)
    try:
        yield audit
    finally:
        store.watchers.remove(audit.watch)
        missing = audit.close(store.state)
        if missing:
            LOG.error("audit: %d records could not be written", missing)
