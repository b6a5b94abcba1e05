"""One console's part of the history: beside a live store, with the faults of disks and of other consoles."""

import sqlite3
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.schema import HistoryConfig
from fleet_tui.model.commands import Stage
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import encode
from fleet_tui.records.history import writer
from fleet_tui.records.history.database import opened_to_read
from fleet_tui.records.history.observing import Fact
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.tables import write as usual
from fleet_tui.records.history.writer import HistoryWriter, history_of
from fleet_tui.state.store import Store
from tests.support.fleets import R0, T0, WALL, pose, queue, tick
from tests.support.polling import eventually
from tests.support.records import ANA, ORDER, give, known_fleet
from tests.support.watched_store import config_of

NOW = (0.0, 1e12)
LONG = HistoryConfig(days=3660)
"""The clock of these tests shows an earlier year."""
SITE = msgspec.structs.replace(config_of("ws://site:9090"), history=LONG)


@pytest.fixture(autouse=True)
def hurry(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "EVERY", 0.01)


@pytest.fixture
def store() -> Store:
    store = Store(known_fleet())
    store.apply(tick(T0 + 1))
    return store


@pytest.fixture
def running(tmp_path: Path) -> Iterator[Callable[..., HistoryWriter]]:
    with ExitStack() as stack:

        def start(store: Store, origin: Origin = ANA) -> HistoryWriter:
            made = stack.enter_context(history_of(tmp_path, SITE, store, origin))
            assert made is not None
            return made

        yield start


Running = Callable[..., HistoryWriter]


def rows(path: Path, table: str) -> int:
    try:
        with opened_to_read(path) as database:
            (count,) = database.execute(f"SELECT count(*) FROM {table}").fetchone()
    except sqlite3.DatabaseError:
        return 0
    return int(count)


def ended(path: Path) -> list[tuple[str, str]]:
    with opened_to_read(path) as database:
        orders = History(database).orders(*NOW)
    return [(order.order, order.stage) for order in orders if order.ended is not None]


def test_commands_orders_spans_and_notes_are_on_disk(store: Store, running: Running) -> None:
    history = running(store)
    give(store, 7, ORDER, Stage.SENT, Stage.ACCEPTED)
    store.apply(queue(T0 + 2, (12, 1, 2, "Q")))
    store.apply(tick(T0 + 2))
    history.add_note("robot_3 squeaks")
    eventually(lambda: rows(history.path, "orders") and rows(history.path, "notes"))
    history.close()
    with opened_to_read(history.path) as database:
        found = History(database)
        assert [one.what for one in found.commands(*NOW)] == ["order"]
        assert [one.way for one in found.orders(*NOW)] == ["Base -> 2"]
        assert [one.text for one in found.notes(*NOW)] == ["robot_3 squeaks"]
        assert [one.operator for one in found.notes(*NOW)] == ["ana"]
        assert found.links(*NOW)[0].is_up
    assert history.notes == []


def test_what_goes_on_at_the_end_is_written(store: Store, running: Running) -> None:
    history = running(store)
    eventually(lambda: rows(history.path, "links"))
    store.apply(pose(T0 + 30))
    store.apply(tick(T0 + 30))
    history.close()
    with opened_to_read(history.path) as database:
        (span,) = History(database).spans(R0, *NOW)
    assert (span.began, span.ended) == (WALL + T0 + 1, WALL + T0 + 30)


def test_of_two_consoles_one_observes_and_both_keep_their_commands(store: Store, running: Running) -> None:
    first = running(store)
    eventually(lambda: rows(first.path, "links"))
    other_store = Store(known_fleet())
    other_store.apply(tick(T0 + 1))
    second = running(other_store, Origin("bob", "host:2", "run2"))
    give(store, 1, ORDER, Stage.SENT)
    give(other_store, 1, ORDER, Stage.SENT)
    eventually(lambda: rows(first.path, "commands") == 2)
    assert rows(first.path, "links") == 1
    first.close()
    eventually(lambda: rows(first.path, "links") == 2)  # the second one observes from now on
    second.close()
    with opened_to_read(first.path) as database:
        assert {one.operator for one in History(database).commands(*NOW)} == {"ana", "bob"}


def test_a_locked_one_is_said_and_written_later(
    store: Store, running: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fleet_tui.records.history.database.BUSY_MS", 10)
    history = running(store)
    eventually(lambda: rows(history.path, "links"))
    with closing(sqlite3.connect(history.path, isolation_level=None)) as other:
        other.execute("BEGIN IMMEDIATE")
        give(store, 1, ORDER, Stage.SENT)
        eventually(lambda: history.notes)
        assert history.notes == ["history: not written: database is locked"]
        other.execute("ROLLBACK")
        eventually(lambda: rows(history.path, "commands") == 1)
    eventually(lambda: not history.notes)


def test_a_full_disk_loses_nothing(store: Store, running: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    history = running(store)
    eventually(lambda: rows(history.path, "links"))
    full = threading.Event()
    full.set()

    def write(database: sqlite3.Connection, fact: Fact, run: str, operator: str) -> None:
        if full.is_set():
            raise sqlite3.OperationalError("database or disk is full")
        usual(database, fact, run, operator)

    monkeypatch.setattr("fleet_tui.records.history.tables.write", write)
    give(store, 1, ORDER, Stage.SENT)
    eventually(lambda: history.notes)
    assert history.notes == ["history: not written: database or disk is full"]
    full.clear()
    eventually(lambda: rows(history.path, "commands") == 1 and history.notes == [])


def one_command(folder: Path) -> Path:
    """An audit log of a pause."""
    log = audit_file(folder / FILE_NAME)
    log.append(encode(ANA.record(time.time(), kind="command", what="pause", change="sent", id=1, robot=R0)))
    log.close()
    return log.path


def test_a_damaged_one_is_kept_aside_and_begun_anew_from_the_audit_log(
    tmp_path: Path, store: Store, running: Running
) -> None:
    log = one_command(tmp_path)
    path = running(store).path
    eventually(lambda: rows(path, "commands") == 1)
    damaged = HistoryWriter(tmp_path / "b.sqlite", log, LONG, store, ANA)
    damaged.path.write_bytes(b"no database\n" * 1000)
    damaged.start()
    eventually(lambda: rows(damaged.path, "commands") == 1)
    damaged.close()
    (aside,) = tmp_path.glob("b-damaged-*.sqlite")
    assert aside.read_bytes().startswith(b"no database")
    assert damaged.notes == [f"history: was damaged: kept as {aside.name}"]


def test_a_folder_that_is_read_only_stops_nothing(store: Store, tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    history = HistoryWriter(blocked / "a.sqlite", tmp_path / FILE_NAME, LONG, store, ANA)
    history.start()
    eventually(lambda: history.notes)
    assert history.notes == ["history: not written: File exists"]
    history.close()


def test_what_is_too_old_goes_at_the_start(
    tmp_path: Path, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = HistoryWriter(tmp_path / "a.sqlite", tmp_path / FILE_NAME, HistoryConfig(days=0.1), store, ANA)
    old.start()
    eventually(lambda: rows(old.path, "hours") == 0 and old.pruned > 0)
    eventually(lambda: rows(old.path, "links") == 0)  # of 2023
    old.close()


def test_a_clock_that_jumped_removes_nothing(
    tmp_path: Path, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as before:
        wall = time.time()
        before.setattr(time, "time", lambda: wall + 86_400.0)
        history = HistoryWriter(
            tmp_path / "a.sqlite", tmp_path / FILE_NAME, HistoryConfig(days=0.1), store, ANA
        )
    history.start()
    eventually(lambda: history.pruned > 0 and rows(history.path, "links") == 1)
    history.close()


def test_that_of_a_demo_ends_with_it(store: Store, tmp_path: Path) -> None:
    with history_of(tmp_path, SITE, store, Origin("ana", "h:1", "r", demo=True)) as history:
        assert history is not None
        eventually(lambda: rows(history.path, "links"))
        assert tmp_path not in history.path.parents
    assert not history.path.exists()


def test_none_is_kept_for_no_days(store: Store, tmp_path: Path) -> None:
    config = msgspec.structs.replace(SITE, history=HistoryConfig(days=0))
    with history_of(tmp_path, config, store, ANA) as history:
        assert history is None
    assert list(tmp_path.iterdir()) == []


def test_an_order_that_two_consoles_saw_counts_once_when_the_second_takes_over(
    store: Store, running: Running
) -> None:
    first = running(store)
    other_store = Store(known_fleet())
    for each in (store, other_store):
        each.apply(queue(T0 + 1, (7, 1, 2, "P"), (8, 1, 2, "Q")))
        each.apply(tick(T0 + 2))
    eventually(lambda: rows(first.path, "orders") == 2)
    store.apply(queue(T0 + 3, (8, 1, 2, "P")))
    store.apply(tick(T0 + 4))
    second = running(other_store, Origin("bob", "host:2", "run2"))
    other_store.apply(queue(T0 + 4, (8, 1, 2, "P")))
    other_store.apply(tick(T0 + 5))
    eventually(lambda: len(ended(first.path)) == 1)
    first.close()  # the last order ends while none of them observes
    other_store.apply(queue(T0 + 9))
    other_store.apply(tick(T0 + 10))
    eventually(lambda: len(ended(first.path)) == 2)
    second.close()
    assert sorted(ended(first.path)) == [("7", "left the queue"), ("8", "lost")]


def test_an_order_that_ended_before_the_second_console_observes_has_its_end(
    store: Store, running: Running
) -> None:
    path = running(store).path
    store.apply(queue(T0 + 1, (7, 1, 2, "Q")))
    store.apply(tick(T0 + 2))
    eventually(lambda: rows(path, "orders") == 1)
    with closing(sqlite3.connect(path)) as killed:  # the first one ends without a word
        killed.execute("UPDATE orders SET run = 'killed'")
        killed.commit()
    other_store = Store(known_fleet())
    other_store.apply(queue(T0 + 1, (7, 1, 2, "Q")))
    other_store.apply(queue(T0 + 3))
    other_store.apply(tick(T0 + 3))
    other_name = path.with_name("other.sqlite")  # whose lock is free, as after the end of a process
    other_name.symlink_to(path)
    second = HistoryWriter(other_name, path, LONG, other_store, Origin("bob", "host:2", "run2"))
    second.start()
    eventually(lambda: ended(path))
    second.close()
    assert ended(path) == [("7", "lost")]


def test_one_that_is_deleted_begins_anew_with_what_goes_on(
    tmp_path: Path, store: Store, running: Running
) -> None:
    one_command(tmp_path)
    path = running(store).path
    store.apply(queue(T0 + 1, (7, 1, 2, "Q")))
    eventually(lambda: rows(path, "orders") == 1)
    path.unlink()
    eventually(lambda: rows(path, "orders") == 1)
    assert rows(path, "commands") == 1  # from the audit log
    assert rows(path, "links") == 1
