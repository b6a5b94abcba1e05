"""Answers of a history: what overlaps a time, of one robot or all."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from fleet_tui.model.commands import RESTARTED
from fleet_tui.model.history.facts import Activity, Charge, LinkChange, OrderChange, Span
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.history.database import open_to_write
from fleet_tui.records.history.observing import HOUR
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.tables import write
from fleet_tui.records.history.writer import prune
from fleet_tui.text.language import Message, counted, translate, verbatim
from fleet_tui.ui.languages import ENGLISH, use_language
from tests.support.records import ANA


@pytest.fixture
def database(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        yield database


def order(database: sqlite3.Connection, name: str, queued: float, ended: float, robot: str = "r") -> None:
    for at, stage in ((queued, "queued"), (ended, "done")):
        if at:
            write(database, OrderChange(robot, name, "A -> B", at, stage), "run1", "ana")


def test_orders_that_overlap_a_time_oldest_first(database: sqlite3.Connection) -> None:
    order(database, "over", 1.0, 9.0)
    order(database, "into", 5.0, 15.0)
    order(database, "open", 3.0, 0.0)
    order(database, "inside", 12.0, 13.0, robot="s")
    order(database, "later", 20.0, 21.0)
    found = History(database)
    assert [one.order for one in found.orders(10.0, 20.0)] == ["open", "into", "inside"]
    assert [one.order for one in found.orders(10.0, 20.0, "s")] == ["inside"]


def test_alarms_that_held_in_a_time_by_their_source(database: sqlite3.Connection) -> None:
    for robot in ("r", "s"):
        told = {"kind": "alarm", "what": "stuck", "robot": robot, "priority": "high"}
        write(database, ANA.record(5.0, change="raised", **told), "run1", "ana")
    write(database, ANA.record(8.0, change="returned, cleared", **told), "run1", "ana")
    found = History(database)
    assert [one.source for one in found.alarms(0.0, 100.0)] == ["r", "s"]
    assert [one.source for one in found.alarms(10.0, 100.0)] == ["r"]
    assert [one.source for one in found.alarms(0.0, 100.0, "s")] == ["s"]


def test_a_link_has_its_last_change_before_the_time_too(database: sqlite3.Connection) -> None:
    changes = [LinkChange("rosbridge", at, bool(n % 2)) for n, at in enumerate((1.0, 2.0, 15.0, 30.0))]
    for change in changes:
        write(database, change, "run1", "ana")
    assert History(database).links(10.0, 20.0) == changes[1:3]


def test_spans_that_overlap_a_time(database: sqlite3.Connection) -> None:
    spans = [
        Span("r", does, began, ended, "floor_0", 1.0, 2.0)
        for does, began, ended in (
            (Activity.DRIVING, 0.0, 10.0),
            (Activity.BLOCKED, 10.0, 30.0),
            (Activity.IDLE, 30.0, HOUR),
            (Activity.BLOCKED, HOUR, HOUR + 5),
        )
    ]
    for span in spans:
        write(database, span, "run1", "ana")
    found = History(database)
    assert found.spans("r", 20.0, 40.0) == spans[1:3]
    assert found.spans("s", 20.0, 40.0) == []
    assert found.blocked(0.0, HOUR) == [spans[1]]
    assert found.seconds("r", HOUR, HOUR)[1] == {Activity.BLOCKED: 5.0}
    assert found.robots(0.0, 10.0) == ["r"]


def test_charges_of_one_robot_in_a_time(database: sqlite3.Connection) -> None:
    for robot in ("r", "s"):
        for at in (1.0, 60.0, 120.0):
            write(database, Charge(robot, at, at / 2), "run1", "ana")
    assert History(database).charges("r", 50.0, 120.0) == [Charge("r", 60.0, 30.0)]


def test_what_goes_on_has_its_operator_whoever_observes(database: sqlite3.Connection) -> None:
    """An order that was only queued, one of another console, one that waits in a console, one of nobody's."""
    order(database, "over", 1.0, 9.0)
    order(database, "5", 3.0, 0.0)
    own = OrderChange("r", "6", "A -> B", 4.0, "queued", request=1)
    write(database, own, "run1", "ana")
    order(database, "7", 5.0, 0.0)
    told = {"kind": "command", "what": "order", "robot": "r", "start": "A", "end": "B"}
    ben = Origin("ben", "host:2", "run2")
    words = "seen in the queue as order 7"
    write(database, ben.record(5.0, change="confirmed", id=1, words=words, **told), "run2", "ben")
    write(database, ben.record(6.0, change="waiting here", id=2, **told), "run2", "ben")
    found = [(one.order, one.stage, one.operator) for one in History(database).open_orders()]
    assert found == [
        ("5", "queued", ""),
        ("6", "queued", "ana"),
        ("7", "queued", "ben"),
        ("", "waiting here", "ben"),
    ]


def test_an_order_that_waits_in_a_console_waits_once_after_its_restarts(database: sqlite3.Connection) -> None:
    told = {"kind": "command", "what": "order", "robot": "r", "id": 1}
    for run, names in (("run1", {"start": "1", "end": "2"}), ("run2", {}), ("run3", {"start_label": "A"})):
        words = "" if run == "run1" else RESTARTED
        console = Origin("ana", "host:1", run)
        write(database, console.record(6.0, change="waiting here", words=words, **told, **names), run, "ana")
    assert len(History(database).open_orders()) == 1


def test_an_order_with_a_unique_name_is_one_whatever_a_console_knows_of_its_way(
    database: sqlite3.Connection,
) -> None:
    for n, way in enumerate(("A -> B", "-> B", "to a point")):
        write(database, OrderChange("r", "161219e8", way, 1.0 + n, "begun"), f"run{n}", "ana")
    assert [(one.order, one.way) for one in History(database).open_orders()] == [("161219e8", "A -> B")]


def test_an_order_has_the_way_of_who_placed_it_whoever_observes(database: sqlite3.Connection) -> None:
    write(database, OrderChange("r", "161219e8", "-> Packing", 6.0, "begun"), "run1", "ana")
    told = {"kind": "command", "what": "order", "robot": "r", "start_label": "Base", "end_label": "Packing"}
    words = "seen in the queue as order 161219e8"
    ben = Origin("ben", "host:2", "run2")
    write(database, ben.record(5.0, change="confirmed", id=1, words=words, **told), "run2", "ben")
    assert [(one.way, one.operator) for one in History(database).open_orders()] == [
        ("Base -> Packing", "ben")
    ]


def test_the_number_of_an_order_of_yesterday_tells_nothing_of_that_of_today(
    database: sqlite3.Connection,
) -> None:
    told = {"kind": "command", "what": "order", "robot": "r", "start": "A", "end": "B", "id": 1}
    words = "seen in the queue as order 3"
    ben = Origin("ben", "host:2", "run2")
    write(database, ben.record(5.0, change="confirmed", words=words, **told), "run2", "ben")
    order(database, "3", 86_400.0, 0.0)
    assert [(one.order, one.operator) for one in History(database).open_orders()] == [("3", "")]


def test_alarms_are_open_until_they_are_over_and_seen(database: sqlite3.Connection) -> None:
    lives = {"r": ["raised"], "s": ["raised", "returned"], "t": ["raised", "returned, cleared"]}
    for robot, changes in lives.items():
        told = {"kind": "alarm", "what": "stuck", "robot": robot, "priority": "high"}
        for at, change in enumerate(changes):
            write(database, ANA.record(5.0 + at, change=change, **told), "run1", "ana")
    assert [(one.source, one.returned) for one in History(database).open_alarms()] == [
        ("r", None),
        ("s", 6.0),
    ]


def test_a_text_with_values_speaks_the_language_of_its_reader(database: sqlite3.Connection) -> None:
    told = {"kind": "alarm", "what": "obstacle", "robot": "r", "priority": "high"}
    blocked = Message("obstacle {duration}", duration="30 s")
    lost = counted("{count} order", "{count} orders", 2)
    failed = Message("not sent: {problem}", problem=Message("no link"))
    write(database, ANA.record(5.0, change="raised", words=blocked, **told), "run1", "ana")
    write(database, LinkChange("rosbridge", 5.0, False, verbatim("no link")), "run1", "ana")
    write(database, OrderChange("r", "1", "A -> B", 6.0, "failed", reason=failed), "run1", "ana")
    write(database, OrderChange("s", "1", "A -> B", 6.0, "failed", reason=lost), "run1", "ana")
    write(database, OrderChange("t", "1", "A -> B", 6.0, "failed", reason="paused"), "run1", "ana")
    found = History(database)
    (alarm,), (link,) = found.alarms(0.0, 9.0), found.links(0.0, 9.0)
    orders = {one.robot: one.reason for one in found.orders(0.0, 9.0)}
    assert (alarm.text, link.reason, orders["r"]) == ("obstacle 30 s", "no link", "not sent: no link")
    use_language("de")
    try:
        assert translate(Message(alarm.text)) == "Hindernis 30 s"
        assert translate(alarm.kind) == "Hindernis"
        assert translate(Message("stuck")) == "steckt fest"
        assert translate(Message(link.reason)) == "no link"  # another one's words
        assert translate(Message(orders["r"])) == "nicht gesendet: keine Verbindung"
        assert translate(Message(orders["s"])) == "2 Aufträge"
        assert translate(Message(orders["t"])) == "paused"  # another one's word, too
    finally:
        use_language(ENGLISH)


@pytest.mark.parametrize("order", [1, -1])
def test_a_text_that_somebody_else_has_said_too_is_not_translated(
    database: sqlite3.Connection, order: int
) -> None:
    texts = [Message("not sent: {problem}", problem=Message("no link")), verbatim("not sent: no link")]
    for at, text in enumerate(texts[::order]):
        write(database, OrderChange(f"r{at}", "1", "A -> B", 6.0, "failed", reason=text), "run1", "ana")
    use_language("de")
    try:
        found = History(database).orders(0.0, 9.0)
        assert [translate(Message(one.reason)) for one in found] == ["not sent: no link"] * 2
    finally:
        use_language(ENGLISH)


def test_texts_of_an_older_console_are_read_as_they_are(database: sqlite3.Connection) -> None:
    write(database, LinkChange("rosbridge", 5.0, False, Message("not sent: {x}", x="1")), "run1", "ana")
    database.execute("DROP TABLE messages")
    assert [one.reason for one in History(database).links(0.0, 9.0)] == ["not sent: 1"]


def test_messages_go_with_the_last_row_that_has_their_text(database: sqlite3.Connection) -> None:
    for at, age in ((5.0, "1 s"), (500.0, "2 s")):
        write(database, LinkChange("rosbridge", at, False, Message("{age} ago", age=age)), "run1", "ana")
    prune(database, 100.0)
    assert database.execute("SELECT text FROM messages").fetchall() == [("2 s ago",)]
