"""Facts in the tables: each once, whatever comes twice or in another sequence."""

import math
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import structs

from fleet_tui.model.history.facts import Activity, Charge, LaterCause, LinkChange, Note, OrderChange, Span
from fleet_tui.model.order_life import STARTED_OVER
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.history.database import SCHEMA, open_to_write
from fleet_tui.records.history.observing import HOUR, Fact
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.tables import UNSEEN, end_unseen, end_unseen_alarms, write, write_all
from tests.support.records import ANA

ALL = (0.0, 1e12)


@pytest.fixture
def database(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        yield database


def put(database: sqlite3.Connection, *facts: Fact | Note) -> History:
    for fact in facts:
        write(database, fact, "run1", "ana")
    return History(database)


def change(stage: str, at: float, request: int | None = None, order: str = "7") -> OrderChange:
    return OrderChange("robot_0", order, "Base -> Store", at, stage, "floor_0", "", request)


def test_an_order_has_one_row_from_queue_to_end(database: sqlite3.Connection) -> None:
    found = put(database, change("queued", 10.0), change("begun", 12.0, 3), change("done", 20.0))
    (order,) = found.orders(*ALL)
    assert (order.queued, order.begun, order.ended) == (10.0, 12.0, 20.0)
    assert (order.stage, order.operator) == ("done", "ana")


def test_an_id_that_starts_over_is_another_order(database: sqlite3.Connection) -> None:
    lost = structs.replace(change("lost", 20.0), reason=STARTED_OVER)
    found = put(database, change("queued", 10.0), lost, change("queued", 30.0))
    assert [order.stage for order in found.orders(*ALL)] == ["lost", "queued"]


def test_an_order_that_nobody_saw_in_the_queue_has_its_end(database: sqlite3.Connection) -> None:
    (order,) = put(database, change("done", 20.0)).orders(*ALL)
    assert (order.queued, order.begun, order.ended) == (20.0, None, 20.0)


def test_an_end_that_two_consoles_tell_counts_once(database: sqlite3.Connection) -> None:
    found = put(database, change("queued", 10.0), change("done", 20.0), change("done", 21.5))
    assert len(found.orders(*ALL)) == 1
    # The same id, at once again: an order of its own.
    found = put(database, change("queued", 22.0), change("done", 23.0))
    assert [order.ended for order in found.orders(*ALL)] == [20.0, 23.0]


def test_an_order_whose_vertices_get_their_names_later_is_one(database: sqlite3.Connection) -> None:
    early = OrderChange("robot_0", "7", "12 -> 4", 10.0, "queued")
    (order,) = put(database, early, change("begun", 12.0), change("done", 20.0)).orders(*ALL)
    assert (order.way, order.stage, order.queued) == ("Base -> Store", "done", 10.0)


def test_a_fact_that_no_table_can_hold_stops_no_other(database: sqlite3.Connection) -> None:
    facts: list[Fact | Note] = [
        Charge("robot_0", 1.0, math.nan),
        Note(2.0, "ana", "half \udc80"),
        Note(3.0, "ana", "whole"),
    ]
    write_all(database, facts, "run1", "ana")
    assert [note.text for note in History(database).notes(*ALL)] == ["whole"]


def test_what_ended_unobserved_is_said_and_what_is_still_listed_goes_on(database: sqlite3.Connection) -> None:
    put(database, change("queued", 10.0), change("queued", 11.0, order="8"), change("begun", 12.0))
    end_unseen(database, "robot_0", {"8"})
    end_unseen(database, "robot_1", set())
    assert [(order.order, order.stage, order.ended) for order in History(database).orders(*ALL)] == [
        ("7", UNSEEN, 12.0),
        ("8", "queued", None),
    ]


def test_an_alarm_of_a_console_that_was_killed_ends_when_anybody_last_watched(
    database: sqlite3.Connection,
) -> None:
    for source, at in (("before", 50.0), ("after", 90.0)):
        told = {"kind": "alarm", "what": "stuck", "robot": source, "priority": "high"}
        write(database, ANA.record(at, change="raised", **told), "run1", "ana")
    put(database, Span("robot_0", Activity.DRIVING, 10.0, 80.0))
    end_unseen_alarms(database, 1000.0, "run2")
    assert [(one.returned, one.ended) for one in History(database).alarms(*ALL)] == [
        (None, 80.0),
        (None, 90.0),
    ]


def test_a_span_that_grows_counts_once(database: sqlite3.Connection) -> None:
    spans = [Span("robot_0", Activity.DRIVING, 100.0, 100.0 + n) for n in (5, 5, 60)]
    found = put(database, *spans)
    assert found.spans("robot_0", *ALL) == [spans[-1]]
    assert found.seconds("robot_0", *ALL) == {0: {Activity.DRIVING: 60.0}}


@given(
    st.lists(
        st.tuples(st.sampled_from(Activity), st.floats(0, 3 * HOUR), st.floats(0, HOUR)),
        max_size=12,
        unique_by=lambda one: one[1],
    )
)
def test_the_hours_are_the_sum_of_the_spans(made: list[tuple[Activity, float, float]]) -> None:
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as database:
        database.executescript(SCHEMA)
        spans = [Span("robot_0", does, began, began + took) for does, began, took in made]
        found = put(database, *spans, *spans)
        hours = found.seconds("robot_0", *ALL)
        for does in Activity:
            told = sum(by_activity.get(does, 0.0) for by_activity in hours.values())
            assert told == pytest.approx(sum(s.ended - s.began for s in spans if s.activity is does))


def test_charges_links_and_notes(database: sqlite3.Connection) -> None:
    charge, up = Charge("robot_0", 5.0, 81.5), LinkChange("rosbridge", 1.0, True)
    note = Note(9.0, "ana", "robot_3 squeaks")
    found = put(database, charge, charge, up, note)
    assert found.charges("robot_0", *ALL) == [charge]
    assert found.links(*ALL) == [up]
    assert found.notes(*ALL) == [note]


def test_a_command_has_its_last_stage(database: sqlite3.Connection) -> None:
    for n, stage in enumerate(("checked", "sent", "refused")):
        write(
            database,
            ANA.record(
                100.0 + n,
                kind="command",
                what="order",
                change=stage,
                id=4,
                robot="robot_0",
                start="1",
                start_label="Base",
                end="2",
                words="queue full" if stage == "refused" else "",
            ),
            "run1",
            "ana",
        )
    (command,) = History(database).commands(*ALL)
    assert (command.at, command.what, command.way) == (100.0, "order", "Base -> 2")
    assert (command.stage, command.reason, command.operator) == ("refused", "queue full", "ana")


def alarm(database: sqlite3.Connection, change: str, at: float) -> None:
    told = ANA.record(
        at,
        kind="alarm",
        what="stuck",
        change=change,
        robot="robot_0",
        words="stuck 61 s",
        priority="high",
        count=2,
    )
    write(database, told, "run1", "ana")


def test_an_alarm_from_raised_to_cleared_and_raised_once_more(database: sqlite3.Connection) -> None:
    for at, change in enumerate(("raised", "returned", "raised again", "acknowledged", "returned, cleared")):
        alarm(database, change, 100.0 + at)
    alarm(database, "raised", 200.0)
    first, again, last = History(database).alarms(*ALL)
    assert (first.raised, first.acknowledged, first.returned, first.ended) == (100.0, None, 101.0, 101.0)
    assert (first.operator, first.priority, first.count) == ("", "high", 2)
    # The time between them does not count as held.
    assert (again.raised, again.acknowledged, again.returned, again.ended) == (102.0, 103.0, 104.0, 104.0)
    assert (again.operator, again.count) == ("ana", 1)
    assert (last.raised, last.acknowledged, last.ended) == (200.0, None, None)


def test_a_cause_that_came_later_is_told_of_the_alarm_that_goes_on(database: sqlite3.Connection) -> None:
    for at, change in enumerate(("raised", "returned, cleared", "raised")):
        alarm(database, change, 100.0 + at)
    put(database, LaterCause("robot_0", "stuck", "stuck: no odometry"))
    first, last = History(database).alarms(*ALL)
    assert first.text != last.text == "stuck: no odometry"


def test_an_alarm_that_returned_holds_no_more_though_nobody_acknowledges_it(
    database: sqlite3.Connection,
) -> None:
    alarm(database, "raised", 100.0)
    alarm(database, "returned", 110.0)
    assert len(History(database).alarms(105.0, 200.0)) == 1
    assert History(database).alarms(120.0, 200.0) == []


def test_an_operator_of_a_console_that_does_not_observe_acknowledges_it(database: sqlite3.Connection) -> None:
    alarm(database, "raised", 100.0)
    for at, operator in ((130.0, "bob"), (140.0, "eve")):
        seen = Origin(operator, "host:2", f"run of {operator}").record(
            at, kind="alarm", what="stuck", change="acknowledged", robot="robot_0", priority="high", count=1
        )
        write(database, seen, seen.run, operator)
    (life,) = History(database).alarms(*ALL)
    assert (life.acknowledged, life.operator, life.ended) == (130.0, "bob", None)


def test_an_inferred_end_is_replaced_by_what_is_known_later(database: sqlite3.Connection) -> None:
    """Also in a history that is made from the audit log, where the correction has a time of its own."""
    for at, stage in ((1.0, "queued"), (5.0, "left the queue"), (5.0, "cancelled elsewhere")):
        write(database, OrderChange("r", "7", "A -> B", at, stage), "run1", "ana")
    for at, stage in ((1.0, "queued"), (5.0, "lost"), (500.0, "done")):
        write(database, OrderChange("r", "8", "A -> B", at, stage, request=3), "run1", "ana")
    for at, stage in ((1.0, "queued"), (5.0, "cancelled elsewhere"), (5.0, "lost"), (9.5, "done")):
        write(database, OrderChange("r", "9", "A -> B", at, stage), "run1", "ana")
    rows = database.execute("SELECT name, stage, ended FROM orders ORDER BY name").fetchall()
    assert rows == [("7", "cancelled elsewhere", 5.0), ("8", "done", 5.0), ("9", "done", 5.0)]


def test_an_order_that_is_listed_again_is_one_order(database: sqlite3.Connection) -> None:
    for at, stage in ((1.0, "queued"), (2.0, "begun"), (5.0, "lost"), (9.0, "begun"), (20.0, "done")):
        write(database, OrderChange("r", "7", "A -> B", at, stage), "run1", "ana")
    for at, stage in ((1.0, "queued"), (5.0, "lost"), (9.0, "queued")):
        write(database, OrderChange("r", "8", "A -> B", at, stage, reason=STARTED_OVER), "run1", "ana")
    rows = database.execute("SELECT name, stage, ended FROM orders ORDER BY id").fetchall()
    assert rows == [("7", "done", 20.0), ("8", "lost", 5.0), ("8", "queued", None)]
