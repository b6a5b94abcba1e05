"""A history that was lost: what the audit log still knows."""

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import encode
from fleet_tui.records.history.database import open_to_write
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.writer import catch_up, order_change, rebuild
from tests.support.records import ANA

ROBOTS = frozenset({"robot_0"})
ALL = (0.0, 1e12)


def step(at: float, change: str, **more: object) -> AuditRecord:
    told = {"kind": "command", "what": "order", "id": 3, "robot": "robot_0", "end": "2", **more}
    return ANA.record(at, change=change, **told)


LIFE = [
    step(100.0, "checked", start="1", start_label="Base"),
    step(101.0, "confirmed", start="1", start_label="Base", order="7"),
    ANA.record(105.0, kind="alarm", what="stuck", change="raised", robot="robot_0", priority="high"),
    step(110.0, "done", start="1", start_label="Base", order="7", words="driven to the end"),
]


def rebuilt(folder: Path, *records: AuditRecord, since: float = 0.0) -> History:
    file = audit_file(folder / FILE_NAME)
    for record in records:
        file.append(encode(record))
    file.close()
    database: sqlite3.Connection = open_to_write(folder / "a.sqlite")[0]
    rebuild(database, file.path, ROBOTS, since)
    return History(database)


def test_commands_orders_and_alarms_come_back(tmp_path: Path) -> None:
    found = rebuilt(tmp_path, *LIFE)
    with closing(found.database):
        (command,), (order,), (alarm,) = found.commands(*ALL), found.orders(*ALL), found.alarms(*ALL)
        assert (command.stage, command.way, command.operator) == ("done", "Base -> 2", "ana")
        assert (order.order, order.queued, order.ended, order.stage) == ("7", 101.0, 110.0, "done")
        assert (order.reason, order.operator) == ("driven to the end", "ana")
        assert (alarm.source, alarm.kind, alarm.raised) == ("robot_0", "stuck", 105.0)


def test_what_is_not_ours_stays_away(tmp_path: Path) -> None:
    foreign = [step(100.0, "sent", robot="robot_9"), replace(LIFE[0], demo=True)]
    found = rebuilt(tmp_path, *foreign, step(5.0, "sent"), since=50.0)
    with closing(found.database):
        assert found.commands(*ALL) == []


def test_commands_that_a_console_could_not_write_are_caught_up_once(tmp_path: Path) -> None:
    found = rebuilt(tmp_path, *LIFE)
    with closing(found.database):
        file = audit_file(tmp_path / FILE_NAME)
        late = [step(200.0, "sent", id=4), step(201.0, "refused", id=4), step(202.0, "console closed", id=4)]
        for record in (*late, step(203.0, "sent", id=5, robot="robot_9")):
            file.append(encode(record))
        for _ in range(2):
            catch_up(found.database, file.path, ROBOTS, 50.0)
        assert [(one.at, one.stage) for one in found.commands(*ALL)] == [(100.0, "done"), (200.0, "refused")]
        assert len(found.orders(*ALL)) == 1 and len(found.alarms(*ALL)) == 1


def test_a_torn_log_gives_what_is_readable(tmp_path: Path) -> None:
    (tmp_path / FILE_NAME).write_bytes(b'{"version":2,"time":"20')
    found = rebuilt(tmp_path, *LIFE)
    with closing(found.database):
        assert len(found.commands(*ALL)) == 1


@pytest.mark.parametrize(
    ("record", "way"),
    [
        (step(1.0, "done", order="7"), "-> 2"),
        (step(1.0, "confirmed", order="7", start="1", end_label="Store"), "1 -> Store"),
    ],
)
def test_the_way_is_that_of_the_order(record: AuditRecord, way: str) -> None:
    change = order_change(record)
    assert change is not None
    assert change.way == way


def test_other_steps_tell_nothing_about_an_order() -> None:
    assert order_change(step(1.0, "sent", order="7")) is None
    assert order_change(step(1.0, "done")) is None
    assert order_change(ANA.record(1.0, kind="alarm", what="stuck", change="done")) is None
