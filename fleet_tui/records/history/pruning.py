"""Bounds a history by age and size."""

import sqlite3

from fleet_tui.config.schema import HistoryConfig
from fleet_tui.records.history.database import transaction
from fleet_tui.records.history.observing import HOUR

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
