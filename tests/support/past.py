"""Histories of consoles in tests."""

import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager, closing, contextmanager
from pathlib import Path

import msgspec

from fleet_tui.config.schema import HistoryConfig
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.history.facts import Note
from fleet_tui.records.history.database import history_path, open_to_write, opened_to_read, transaction
from fleet_tui.records.history.observing import Fact
from fleet_tui.records.history.tables import write
from fleet_tui.records.history.writer import HistoryWriter, history_of
from fleet_tui.state.store import Store
from tests.support.records import ANA, known_fleet
from tests.support.watched_store import config_of

LONG = HistoryConfig(days=3660)
"""The clock of many tests shows an earlier year."""


SITE = msgspec.structs.replace(config_of("ws://site:9090"), history=LONG)


def put(folder: Path, facts: Iterable[Fact | Note | AuditRecord]) -> None:
    """Write facts into that history, before or while a console writes it."""
    database, _ = open_to_write(history_path(folder, SITE))
    with closing(database), transaction(database):
        for fact in facts:
            write(database, fact, "run1", "ana")


@contextmanager
def kept_history(folder: Path, store: Store | None = None) -> Iterator[HistoryWriter]:
    """The history of a console of ana in a folder."""
    with history_of(folder, SITE, store or Store(known_fleet()), ANA) as writer:
        assert writer is not None
        yield writer


def read_history(path: Path) -> AbstractContextManager[sqlite3.Connection]:
    """The database of a history that was closed."""
    return opened_to_read(path)
