"""Sums of a history: the same whether by seconds or by hours, and by anybody who adds it up."""

import sqlite3
from collections import defaultdict
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.history.facts import Activity, Charge, OrderChange, Span
from fleet_tui.records.history.database import SCHEMA, open_to_write
from fleet_tui.records.history.division import divided
from fleet_tui.records.history.observing import HOUR
from fleet_tui.records.history.tables import write
from fleet_tui.records.history.totals import Totals


@pytest.fixture
def database(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        yield database


def drive(database: sqlite3.Connection, id_: int, begun: float, ended: float, stage: str = "done") -> None:
    for at, step in ((begun - 5, "queued"), (begun, "begun"), (ended, stage)):
        write(database, OrderChange("robot_0", str(id_), "A -> B", at, step), "run1", "ana")


def test_an_order_is_late_beyond_twice_the_usual_time_of_its_way(database: sqlite3.Connection) -> None:
    for id_, took in enumerate((50.0, 50.0, 50.0, 50.0, 50.0, 200.0)):
        drive(database, id_, 100.0 * id_ + 10, 100.0 * id_ + 10 + took)
    drive(database, 90, 900.0, 990.0, "lost")
    done, lost = Totals(database).orders(0.0, 1000.0)
    assert (done.count, done.late, done.timed, done.seconds, done.longest) == (6, 1, 6, 450.0, 200.0)
    assert (lost.stage, lost.count, lost.late) == ("lost", 1, 0)
    (few,) = Totals(database).orders(300.0, 500.0)
    assert (few.count, few.late) == (2, 0)  # too few for a usual time
    assert Totals(database).orders(2000.0, 3000.0) == []


@given(
    st.lists(
        st.tuples(st.sampled_from(Activity), st.floats(0.0, 70 * HOUR), st.floats(1.0, HOUR)),
        max_size=12,
        unique_by=lambda one: round(one[1]),
    )
)
def test_activities_are_those_of_the_spans(spans: list[tuple[Activity, float, float]]) -> None:
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as database:
        database.executescript(SCHEMA)
        whole: dict[Activity, float] = defaultdict(float)
        for activity, began, took in spans:
            write(database, Span("robot_0", activity, began, began + took), "run1", "ana")
            whole[activity] += took
        for until in (72 * HOUR, 40 * HOUR):
            found: dict[Activity, float] = defaultdict(float)
            for total in Totals(database).activities(divided(0.0, until, 50)):
                assert 0 <= total.part < 50
                found[total.activity] += total.seconds
            if until > 71 * HOUR:
                assert found == pytest.approx(whole)
            exact = dict.fromkeys(whole, 0.0)
            for activity, began, took in spans:
                exact[activity] += max(0.0, min(until, began + took) - began)
            assert {each: found[each] for each in exact} == pytest.approx(exact)


@pytest.mark.parametrize("until", [10 * HOUR, 80 * HOUR])
def test_charges_have_the_lowest_and_the_last_of_each_part(
    database: sqlite3.Connection, until: float
) -> None:
    for minute in range(120):
        write(database, Charge("robot_0", 60.0 * minute, 100.0 - minute), "run1", "ana")
        write(database, Charge("robot_1", 60.0 * minute, minute + 1.0), "run1", "ana")
    write(database, Span("robot_0", Activity.IDLE, 0.0, 10.0), "run1", "ana")
    write(database, Span("robot_1", Activity.IDLE, 0.0, 10.0), "run1", "ana")
    found = Totals(database).charges(divided(0.0, until, round(until / HOUR)))
    assert [(one.robot, one.part, one.low, one.last) for one in found] == [
        ("robot_0", 0, 41.0, 41.0),
        ("robot_0", 1, -19.0, -19.0),
        ("robot_1", 0, 1.0, 60.0),
        ("robot_1", 1, 61.0, 120.0),
    ]


def test_blocked_places_are_summed_by_cell_the_worst_first(database: sqlite3.Connection) -> None:
    for n, (x, y, seconds) in enumerate(((1.1, -0.1, 60.0), (1.4, -0.4, 30.0), (3.0, 3.0, 200.0))):
        began = 1000.0 * n
        write(database, Span("r", Activity.BLOCKED, began, began + seconds, "floor_0", x, y), "run1", "ana")
    write(database, Span("r", Activity.DRIVING, 5000.0, 5100.0, "floor_0", 9.0, 9.0), "run1", "ana")
    write(database, Span("r", Activity.BLOCKED, 6000.0, 6100.0, "", 0.0, 0.0), "run1", "ana")
    found = Totals(database).blocked(0.0, 9000.0)
    assert [(one.x, one.y, one.seconds) for one in found] == [(3.25, 3.25, 200.0), (1.25, -0.25, 90.0)]
    assert [one.seconds for one in Totals(database).blocked(2100.0, 2150.0)] == [50.0]
