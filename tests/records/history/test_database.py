"""The file of a history: made, opened again, damaged, of another program."""

import sqlite3
import stat
from contextlib import closing
from datetime import datetime
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.schema import Config, Link
from fleet_tui.records.history.database import (
    history_path,
    is_damaged,
    open_to_write,
    opened_to_read,
    put_aside,
    transaction,
)


def test_a_new_one_is_private_and_known_as_new_once(tmp_path: Path) -> None:
    path = tmp_path / "history" / "a.sqlite"
    database, is_new = open_to_write(path)
    assert is_new
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    database.close()
    database, is_new = open_to_write(path)
    assert not is_new
    database.close()


def test_a_mode_that_was_opened_up_is_closed_again(tmp_path: Path) -> None:
    path = tmp_path / "a.sqlite"
    open_to_write(path)[0].close()
    path.chmod(0o644)
    open_to_write(path)[0].close()
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


def test_a_failed_transaction_leaves_nothing(tmp_path: Path) -> None:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        with pytest.raises(ZeroDivisionError), transaction(database):
            database.execute("INSERT INTO notes VALUES (1, 'ana', 'x')")
            _ = 1 / 0
        assert database.execute("SELECT count(*) FROM notes").fetchone() == (0,)


def test_it_is_read_while_it_is_written(tmp_path: Path) -> None:
    path = tmp_path / "a b#?.sqlite"
    database, _ = open_to_write(path)
    with closing(database), transaction(database), opened_to_read(path) as reader:
        database.execute("INSERT INTO notes VALUES (1, 'ana', 'x')")
        assert reader.execute("SELECT count(*) FROM notes").fetchone() == (0,)
        with pytest.raises(sqlite3.OperationalError, match="readonly"):
            reader.execute("DELETE FROM notes")


def test_a_missing_one_is_not_made_by_reading(tmp_path: Path) -> None:
    with pytest.raises(sqlite3.OperationalError), opened_to_read(tmp_path / "none.sqlite"):
        pass
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("content", [b"hello\n" * 1000, b"SQLite format 3\x00" + b"\xff" * 9000])
def test_a_damaged_one_is_known_and_put_aside(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "a.sqlite"
    path.write_bytes(content)
    with pytest.raises(sqlite3.DatabaseError) as raised:
        open_to_write(path)
    assert is_damaged(raised.value)
    aside = put_aside(path, datetime(2026, 3, 4, 5, 6, 7).astimezone())
    assert aside.name == "a-damaged-20260304-050607.sqlite"
    assert aside.read_bytes() == content
    open_to_write(path)[0].close()


def test_a_newer_one_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "a.sqlite"
    database, _ = open_to_write(path)
    database.execute("PRAGMA user_version = 99")
    database.close()
    with pytest.raises(sqlite3.NotSupportedError, match="newer fleet-tui") as raised:
        open_to_write(path)
    assert not is_damaged(raised.value)


def test_each_site_has_its_own(tmp_path: Path) -> None:
    typed = Config(rosbridge=Link("ws://one:9090"))
    paths = {
        history_path(tmp_path, typed),
        history_path(tmp_path, msgspec.structs.replace(typed, rosbridge=Link("ws://two:9090"))),
        history_path(tmp_path, msgspec.structs.replace(typed, path=tmp_path / "config.toml")),
    }
    assert len(paths) == 3
    moved = msgspec.structs.replace(typed, path=tmp_path / "config.toml", rosbridge=Link("ws://three:9090"))
    assert history_path(tmp_path, moved) in paths
