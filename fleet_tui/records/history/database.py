"""The database of one site's history: its tables, and how it is opened."""

import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from datetime import datetime
from hashlib import sha256
from pathlib import Path

from fleet_tui.config.schema import Config

VERSION = 1
BUSY_MS = 2000
"""Milliseconds for which a writer waits for another one."""
CACHE_KIB = 512
"""Memory for pages of a writer, which reads few again: SQLite's own 2 MB fill within half an hour."""
FOLDER = "history"
SUFFIX = ".sqlite"

SCHEMA = """
CREATE TABLE orders (
  id INTEGER PRIMARY KEY, robot TEXT NOT NULL, name TEXT NOT NULL, way TEXT NOT NULL, floor TEXT NOT NULL,
  queued REAL NOT NULL, begun REAL, ended REAL, stage TEXT NOT NULL, reason TEXT NOT NULL,
  operator TEXT NOT NULL, run TEXT NOT NULL, request INTEGER);
CREATE INDEX orders_by_time ON orders (queued);
CREATE INDEX orders_by_end ON orders (ended, way, robot, stage, begun);
CREATE INDEX orders_by_robot ON orders (robot, queued);
CREATE INDEX orders_open ON orders (robot, name) WHERE ended IS NULL;
CREATE TABLE commands (
  run TEXT NOT NULL, id INTEGER NOT NULL, at REAL NOT NULL, operator TEXT NOT NULL, robot TEXT NOT NULL,
  what TEXT NOT NULL, way TEXT NOT NULL, stage TEXT NOT NULL, reason TEXT NOT NULL, PRIMARY KEY (run, id));
CREATE INDEX commands_by_time ON commands (at);
CREATE TABLE alarms (
  id INTEGER PRIMARY KEY, run TEXT NOT NULL, source TEXT NOT NULL, kind TEXT NOT NULL, priority TEXT NOT NULL,
  text TEXT NOT NULL, raised REAL NOT NULL, returned REAL, acknowledged REAL, ended REAL,
  operator TEXT NOT NULL, count INTEGER NOT NULL);
CREATE INDEX alarms_by_time ON alarms (raised);
CREATE INDEX alarms_open ON alarms (run, source, kind) WHERE ended IS NULL;
CREATE TABLE links (at REAL NOT NULL, link TEXT NOT NULL, is_up INTEGER NOT NULL, reason TEXT NOT NULL);
CREATE INDEX links_by_time ON links (at);
CREATE TABLE spans (
  robot TEXT NOT NULL, began REAL NOT NULL, ended REAL NOT NULL, activity TEXT NOT NULL, floor TEXT NOT NULL,
  x REAL NOT NULL, y REAL NOT NULL, PRIMARY KEY (robot, began)) WITHOUT ROWID;
CREATE INDEX spans_blocked ON spans (began) WHERE activity = 'blocked';
CREATE TABLE hours (
  robot TEXT NOT NULL, hour INTEGER NOT NULL, activity TEXT NOT NULL, seconds REAL NOT NULL,
  PRIMARY KEY (robot, hour, activity)) WITHOUT ROWID;
CREATE TABLE charges (
  robot TEXT NOT NULL, at REAL NOT NULL, percent REAL NOT NULL, PRIMARY KEY (robot, at)) WITHOUT ROWID;
CREATE TABLE charge_hours (
  robot TEXT NOT NULL, hour INTEGER NOT NULL, low REAL NOT NULL, last REAL NOT NULL,
  PRIMARY KEY (robot, hour)) WITHOUT ROWID;
CREATE TABLE notes (at REAL NOT NULL, operator TEXT NOT NULL, text TEXT NOT NULL);
CREATE INDEX notes_by_time ON notes (at);
"""
MESSAGES = """
CREATE TABLE IF NOT EXISTS messages (text TEXT PRIMARY KEY, message TEXT NOT NULL) WITHOUT ROWID
"""
"""Texts with values, by their English, which the other tables have: for readers in another language. Added
after version 1, which can do without."""


def history_path(folder: Path, config: Config) -> Path:
    """Return the file of a site in the state folder. Sites with robots of the same names have their own."""
    named = str(config.path.absolute()) if config.path.suffix else ""
    places = named or "\n".join(link.url for link in config.bridges.values())
    return folder / FOLDER / f"{sha256(places.encode()).hexdigest()[:12]}{SUFFIX}"


def open_to_write(path: Path) -> tuple[sqlite3.Connection, bool]:
    """Open or create a database; True if it is new. One of a newer program, and one that is damaged, raises
    sqlite3.DatabaseError; OSError if the folder can't be made."""
    path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    os.close(os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600))
    with suppress(OSError):  # another user's file: the mode is theirs
        path.chmod(0o600)
    database = sqlite3.connect(path, isolation_level=None, check_same_thread=False, timeout=BUSY_MS / 1000)
    try:
        return database, _prepare(database)
    except sqlite3.Error:
        database.close()
        raise


def _prepare(database: sqlite3.Connection) -> bool:
    database.execute("PRAGMA auto_vacuum = INCREMENTAL")  # only before the first table
    database.execute("PRAGMA journal_mode = WAL")
    database.execute("PRAGMA synchronous = NORMAL")
    database.execute(f"PRAGMA cache_size = -{CACHE_KIB}")
    (version,) = database.execute("PRAGMA user_version").fetchone()
    if version > VERSION:
        raise sqlite3.NotSupportedError("written by a newer fleet-tui")
    if version == VERSION:
        database.execute(MESSAGES)
        return False
    with transaction(database):
        (version,) = database.execute("PRAGMA user_version").fetchone()  # another console may have been first
        if version == 0:
            for statement in SCHEMA.split(";"):
                database.execute(statement)
            database.execute(MESSAGES)
            database.execute(f"PRAGMA user_version = {VERSION}")
    return bool(version == 0)


@contextmanager
def transaction(database: sqlite3.Connection) -> Iterator[None]:
    """All of it is written, or nothing."""
    database.execute("BEGIN IMMEDIATE")
    try:
        yield
    except BaseException:
        database.execute("ROLLBACK")
        raise
    database.execute("COMMIT")


@contextmanager
def opened_to_read(path: Path) -> Iterator[sqlite3.Connection]:
    """Open an existing database, which a console may be writing. Raises sqlite3.Error."""
    with closing(
        sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True, timeout=BUSY_MS / 1000)
    ) as database:
        yield database


def is_empty(database: sqlite3.Connection) -> bool:
    """Tell whether its first writer has not made its tables yet. Raises sqlite3.Error."""
    (version,) = database.execute("PRAGMA user_version").fetchone()
    return bool(version == 0)


def is_damaged(problem: sqlite3.Error) -> bool:
    """Tell whether a database has to begin anew: its file is no database, or its content contradicts
    itself."""
    damaged = (sqlite3.SQLITE_CORRUPT, sqlite3.SQLITE_NOTADB)
    code = getattr(problem, "sqlite_errorcode", None)
    return code is not None and code & 0xFF in damaged


def identity(path: Path) -> tuple[int, int] | None:
    """Return what tells a file from another one of the same name, None if there is none."""
    try:
        stat = path.stat()
    except OSError:
        return None
    return stat.st_dev, stat.st_ino


def put_aside(path: Path, now: datetime) -> Path:
    """Rename a damaged database, with what belongs to it; return its new name. Raises OSError."""
    aside = path.with_name(f"{path.stem}-damaged-{now:%Y%m%d-%H%M%S}{SUFFIX}")
    for ending in ("-wal", "-shm", ""):
        with suppress(FileNotFoundError):
            Path(f"{path}{ending}").rename(f"{aside}{ending}")
    return aside
