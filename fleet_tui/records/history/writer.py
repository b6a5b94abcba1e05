"""Writes the history of a fleet in a thread of its own: a disk that hangs or is full stops nothing else."""

import logging
import sqlite3
import time
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from datetime import datetime
from functools import partial
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory

from fleet_tui.config.schema import Config, HistoryConfig
from fleet_tui.model.alarm import AlarmStep
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Note, OrderChange
from fleet_tui.records.audit.entries import Origin, alarm_records, command_records, held_records
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.history.database import (
    history_path,
    identity,
    is_damaged,
    open_to_write,
    put_aside,
    transaction,
)
from fleet_tui.records.history.observing import HOUR, Fact, Observer
from fleet_tui.records.history.tables import (
    ENDS,
    end_unseen,
    end_unseen_alarms,
    write,
    write_all,
    write_record,
)
from fleet_tui.state.store import Store
from fleet_tui.storage.lock import LockFile
from fleet_tui.storage.worker import Worker
from fleet_tui.storage.write_queue import WriteQueue
from fleet_tui.text.language import EMPTY, Message, verbatim

MOST = 200_000
"""Records that are read, the newest ones."""
STAGES = {Stage.CONFIRMED.value: "queued", **{end: end for end in ENDS}}


def rebuild(database: sqlite3.Connection, audit: Path, robots: frozenset[str], since: float) -> int:
    """Write the records of real fleets' robots since a moment; return their number. Raises OSError."""
    newest = (record for record in AuditReader(audit).newest_first() if not record.demo)
    kept = [one for one in islice(newest, MOST) if _is_ours(one, robots) and _at(one) >= since]
    for record in reversed(kept):
        write_record(database, record)
        change = order_change(record)
        if change is not None:
            write(database, change, record.run, record.operator)
    return len(kept)


def catch_up(database: sqlite3.Connection, audit: Path, robots: frozenset[str], since: float) -> None:
    """Write the steps of commands since a moment once more: a console that ended while the disk was full, or
    the file locked, could not. Raises OSError."""
    found = []
    for record in islice(AuditReader(audit).newest_first(), MOST):
        if _at(record) < since:
            break
        if record.kind == "command" and record.robot in robots and not record.demo:
            found.append(record)
    for record in reversed(found):
        write_record(database, record)


def _is_ours(record: AuditRecord, robots: frozenset[str]) -> bool:
    return record.kind in ("command", "alarm") and (not record.robot or record.robot in robots)


def _at(record: AuditRecord) -> float:
    return datetime.fromisoformat(record.time).timestamp()


def order_change(record: AuditRecord) -> OrderChange | None:
    """Return what a record tells about an order that was placed, None if nothing."""
    stage = STAGES.get(record.change)
    if stage is None or record.order is None or record.end is None:
        return None
    names = [record.start_label or record.start, record.end_label or record.end]
    way = " -> ".join(filter(None, names)) if names[0] else f"-> {names[1]}"
    words = record.words if stage in ENDS else ""
    at = _at(record)
    return OrderChange(record.robot, record.order, way, at, stage, record.floor, words, record.id)


DAY = 86_400.0
PARTS = (1.0, 0.75, 0.5, 0.25, 0.1)
"""Parts of the days that are kept, until the file is small enough."""

TEXTS = (("orders", "reason"), ("commands", "reason"), ("links", "reason"), ("alarms", "text"))
"""Columns with the texts of messages."""


def shrink(database: sqlite3.Connection, now: float, config: HistoryConfig) -> None:
    """Remove what is too old at a time in Unix seconds, and the oldest while the file is too large."""
    for part in PARTS:
        with transaction(database):
            prune(database, now - part * config.days * DAY)
        database.executescript("PRAGMA incremental_vacuum")  # `execute` would free a single page
        if _bytes_of(database) <= config.megabytes * 1e6:
            return


def prune(database: sqlite3.Connection, before: float) -> None:
    """Remove what is older than a moment, and give its space back."""
    for table, column in (
        ("orders", "queued"),
        ("commands", "at"),
        ("alarms", "raised"),
        ("links", "at"),
        ("notes", "at"),
    ):
        database.execute(f"DELETE FROM {table} WHERE {column} < ?", (before,))
    used = " UNION ".join(f"SELECT {column} FROM {table}" for table, column in TEXTS)
    database.execute(f"DELETE FROM messages WHERE text NOT IN ({used})")
    for table, column in (("spans", "began"), ("charges", "at")):
        # By robot: so the tables need no further index, which would be as large as they are.
        robots = "robot IN (SELECT DISTINCT robot FROM hours)"
        database.execute(f"DELETE FROM {table} WHERE {robots} AND {column} < ?", (before,))
    for table in ("charge_hours", "hours"):
        database.execute(f"DELETE FROM {table} WHERE hour < ?", (int(before // HOUR),))


def _bytes_of(database: sqlite3.Connection) -> int:
    (pages,), (size,) = (
        database.execute(f"PRAGMA {name}").fetchone() for name in ("page_count", "page_size")
    )
    return int(pages) * int(size)


LOG = logging.getLogger(__name__)

EVERY = 1.0
"""Seconds between two looks at the fleet."""
CATCHES_UP = 2 * DAY
"""Seconds of the audit log whose commands are written again when an existing history is opened."""
WAITING = 50_000
"""Facts that wait for a writable disk; of more the oldest are lost, and counted."""
PRUNE_EVERY = 3600.0
LAST_CHANCE = 1.0
"""Seconds at the end after which an unresponsive disk is given up."""
MOVES_CLOCK = 3600.0
"""Seconds by which a clock may jump before nothing is removed by its time any more."""


class HistoryWriter:
    """One console's part of the history. Its own commands are written by every console; what robots do by
    one of those that observe the same site, the first."""

    def __init__(self, path: Path, audit: Path, config: HistoryConfig, store: Store, origin: Origin) -> None:
        self.path = path
        self.problem = EMPTY
        self.note = ""
        self._audit = audit
        self._config = config
        self._store = store
        self._origin = origin
        self._facts = WriteQueue[Fact | Note | AuditRecord](WAITING)
        self._changes: deque[tuple[FleetState, FleetState, float, float]] = deque(maxlen=WAITING)
        self._database: sqlite3.Connection | None = None
        self._file: tuple[int, int] | None = None
        self._turn = turn_at(path)
        self._is_observing = False
        self._observer = Observer()
        self._seen: set[str] = set()
        self._has_ended_alarms = False
        self.pruned = -PRUNE_EVERY
        self._clock = time.time() - time.monotonic()
        self._worker = Worker("history", self._step, EVERY, self._end)

    @property
    def notes(self) -> list[Message]:
        """Return notes for the operator; empty while all is written."""
        told = (
            [Message("not written: {problem}", problem=self.problem)]
            if self.problem
            else [self.note]
            if self.note
            else []
        )
        return [Message("history: {problem}", problem=one) for one in told]

    def start(self) -> None:
        """Begin to observe."""
        self._store.watchers.append(self.watch)
        self._worker.start()

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Keep a change of commands or alarms; written later."""
        self._changes.append((before, after, time.monotonic(), time.time()))

    def add_note(self, text: str, by: str = "", wall: float = 0.0) -> Note:
        """Write a remark for whoever takes over: made here now, or elsewhere (`by`) at Unix second `wall`."""
        self._facts.append(note := Note(wall or time.time(), by or self._origin.operator, text))
        return note

    def close(self) -> None:
        """Write what is left."""
        with suppress(ValueError):
            self._store.watchers.remove(self.watch)
        self._worker.close(LAST_CHANCE)

    def _step(self) -> None:
        try:
            self._collect()
        finally:  # a mistake of ours in one state must not keep the others
            self._write()

    def _end(self) -> None:
        self._collect()
        for fact in self._observer.finish() if self._is_observing else ():
            self._facts.append(fact)
        self._write()
        if self._database is not None:
            self._database.close()
        self._turn.release()

    def _collect(self) -> None:
        """Take what happened since the last time."""
        observed, self._is_observing = self._is_observing, takes(self._turn)
        if self._is_observing and not observed:  # what another console raised goes on here
            self._raise_held()
        while self._changes:
            before, after, at, wall = self._changes.popleft()
            for record in command_records(self._origin, before, after, partial(_wall, at, wall)):
                self._facts.append(record)
            for record in alarm_records(self._origin, before, after, wall):
                # An operator acknowledges here, also if another console observes.
                if self._is_observing or record.change.startswith(AlarmStep.ACKNOWLEDGE.value):
                    self._facts.append(record)
        if self._is_observing:
            for fact in self._observer.observe(self._store.state):
                self._facts.append(fact)

    def _raise_held(self) -> None:
        for record in held_records(self._origin, self._store.state, time.time()):
            self._facts.append(record)

    def _write(self) -> None:
        """Write all that waits, in one transaction; what could not be written waits on."""
        try:
            database = self._opened()
            taken = list(self._facts)
            with transaction(database):
                self._end_unseen(database)
                write_all(database, taken, self._origin.run, self._origin.operator)
            for _ in taken:
                self._facts.popleft()
            self._prune(database)
        except (sqlite3.Error, OSError) as problem:
            self._failed(problem)
        else:
            self.problem = EMPTY
            if self._facts.lost:
                LOG.error("history: %d facts not written", self._facts.lost)
                self._facts.lost = 0

    def _opened(self) -> sqlite3.Connection:
        if self._database is not None and self._file != identity(self.path):
            self._database.close()  # it was deleted, or put aside by another console
            self._database = None
        if self._database is None:
            self._database, is_new = open_to_write(self.path)
            if is_new and self._file is not None:
                self._begin_anew()
            self._file = identity(self.path)
            if not self._origin.demo:
                robots, now = frozenset(self._store.state.robots), time.time()
                with transaction(self._database), suppress(OSError):
                    if is_new:
                        rebuild(self._database, self._audit, robots, now - self._config.days * DAY)
                    else:
                        catch_up(self._database, self._audit, robots, now - CATCHES_UP)
        return self._database

    def _begin_anew(self) -> None:
        """Tell again what goes on: a new database knows none of it."""
        self._observer = Observer()
        self._has_ended_alarms = False
        self._seen.clear()
        if self._is_observing:
            self._raise_held()

    def _end_unseen(self, database: sqlite3.Connection) -> None:
        """Of what was open when nobody watched end all alarms, and the orders that no queue lists."""
        if not self._turn.is_held:
            return
        if not self._has_ended_alarms:
            end_unseen_alarms(database, time.time(), self._origin.run)
            self._has_ended_alarms = True
        for robot in self._store.state.robots.values():
            if robot.queue is not None and robot.name not in self._seen:
                # Those that this console saw leave have their end among the facts.
                end_unseen(database, robot.name, {*robot.traces, *(one.order.id for one in robot.gone)})
                self._seen.add(robot.name)

    def _failed(self, problem: sqlite3.Error | OSError) -> None:
        words = verbatim(getattr(problem, "strerror", None) or problem)
        if self._database is not None:
            with suppress(sqlite3.Error):
                self._database.close()
            self._database = None
        # One console only: a second one would put aside what the first has begun.
        if isinstance(problem, sqlite3.Error) and is_damaged(problem) and self._turn.is_held:
            with suppress(OSError):
                self.note = Message(
                    "was damaged: kept as {name}", name=put_aside(self.path, datetime.now().astimezone()).name
                )
                LOG.error("history: %s: %s", self.path, self.note)
                return
        if words != self.problem:
            LOG.error("history: not written: %s: %s", self.path, words)
        self.problem = words

    def _prune(self, database: sqlite3.Connection) -> None:
        """Remove what is too old, and the oldest while the file is too large. A clock that jumped removes
        nothing."""
        now = time.monotonic()
        if now - self.pruned < PRUNE_EVERY or not self._turn.is_held:
            return
        self.pruned = now
        wall = time.time()
        if abs(wall - now - self._clock) > MOVES_CLOCK:
            return
        shrink(database, wall, self._config)


def turn_at(path: Path) -> LockFile:
    """Return the turn to do what one of several consoles does: beside this file."""
    return LockFile(Path(f"{path}.lock"))


def takes(turn: LockFile) -> bool:
    """Tell whether it is this process's turn; also where there can be no lock: the database will say why."""
    try:
        return turn.take()
    except OSError:
        return True


def _wall(now: float, wall: float, at: float) -> float:
    return wall - (now - at)


@contextmanager
def history_of(folder: Path, config: Config, store: Store, origin: Origin) -> Iterator[HistoryWriter | None]:
    """Keep the history of a console in the state folder while it runs; None if it is switched off. That of
    a demo ends with it."""
    if not config.history.days:
        yield None
        return
    with TemporaryDirectory(prefix="fleet-tui-") if origin.demo else nullcontext(str(folder)) as place:
        path = history_path(Path(place), config)
        writer = HistoryWriter(path, folder / FILE_NAME, config.history, store, origin)
        writer.start()
        try:
            yield writer
        finally:
            writer.close()
