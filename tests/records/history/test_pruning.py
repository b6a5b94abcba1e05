"""A history is bounded by age and size."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from fleet_tui.config.schema import HistoryConfig
from fleet_tui.model.history.facts import Charge
from fleet_tui.records.history.database import open_to_write, transaction
from fleet_tui.records.history.tables import write
from fleet_tui.records.history.writer import DAY, prune, shrink
from tests.support.shift import shift

TABLES = ("orders", "commands", "alarms", "links", "notes", "spans", "charges", "hours", "charge_hours")


@pytest.fixture
def database(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        yield database


def times(database: sqlite3.Connection) -> dict[str, int]:
    return {table: database.execute(f"SELECT count(*) FROM {table}").fetchone()[0] for table in TABLES}


def test_what_is_too_old_goes_from_every_table(database: sqlite3.Connection) -> None:
    for fact in shift(1 * DAY):
        write(database, fact, "run1", "ana")
    once = times(database)
    assert all(once.values())
    for fact in shift(9 * DAY):
        write(database, fact, "run2", "ana")
    prune(database, 5 * DAY)
    assert times(database) == {**once, "commands": 0}  # its command is the same one, told again
    prune(database, 99 * DAY)
    assert not any(times(database).values())


def test_the_oldest_go_while_it_is_too_large(database: sqlite3.Connection) -> None:
    with transaction(database):
        for minute in range(60_000):
            write(database, Charge("robot_0", 60.0 * minute, 80.0), "run1", "ana")
            if minute % 60 == 0:
                database.execute("INSERT INTO hours VALUES ('robot_0', ?, 'idle', 3600)", (minute // 60,))
    shrink(database, 60.0 * 60_000, HistoryConfig(days=3000, megabytes=1))
    (oldest, newest) = database.execute("SELECT min(at), max(at) FROM charges").fetchone()
    assert (oldest, newest) != (0.0, None)
    shrink(database, 60.0 * 60_000, HistoryConfig(days=40, megabytes=1))
    (oldest, newest) = database.execute("SELECT min(at), max(at) FROM charges").fetchone()
    (pages,) = database.execute("PRAGMA page_count").fetchone()
    assert pages * 4096 <= 1e6 and oldest > 60.0 * 60_000 - 40 * DAY and newest == 60.0 * 59_999
