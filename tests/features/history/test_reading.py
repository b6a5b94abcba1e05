"""The contents that each page of the history reads."""

import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from fleet_tui.features.history.controls import PAGES, read_page
from fleet_tui.keys import HISTORY_PAGES
from fleet_tui.model.history.facts import Activity, Charge
from fleet_tui.records.history.database import open_to_write, transaction
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.tables import write
from tests.support.shift import shift

TIME = Division(0.0, 1800.0, 6)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database), transaction(database):
        for fact in shift(0.0):
            write(database, fact, "run1", "ana")
        for minute in range(30):
            write(database, Charge("robot_0", 60.0 * minute + 1, 80.0 - minute), "run1", "ana")
    return tmp_path / "a.sqlite"


def test_every_page_is_read() -> None:
    assert list(PAGES) == list(HISTORY_PAGES)


def test_each_page_reads_its_own(path: Path) -> None:
    events = read_page(path, "Events", TIME, 20.0)
    assert len(events.events) == 8 and events.timeline == {} and events.begun == 20.0
    robots = read_page(path, "Robots", TIME, 20.0)
    assert (
        robots.timeline["robot_0"][0] is Activity.BLOCKED and robots.timeline["robot_0"][5] is Activity.IDLE
    )
    batteries = read_page(path, "Batteries", TIME, 20.0)
    assert batteries.charges["robot_0"][0].low == 76.0 and batteries.forecasts["robot_0"].empty_in > 0
    assert [one.kind for one in read_page(path, "Alarms", TIME, 20.0).alarms] == ["stuck"]
    assert [one.seconds for one in read_page(path, "Places", TIME, 20.0).places] == [300.0]


def test_what_can_not_be_read_is_said(tmp_path: Path, path: Path) -> None:
    assert "can't be read: unable to open" in read_page(tmp_path / "no", "Events", TIME, 20.0).problem
    (tmp_path / "empty.sqlite").touch()
    assert read_page(tmp_path / "empty.sqlite", "Events", TIME, 20.0).problem == "nothing recorded yet"
    with closing(sqlite3.connect(path)) as database:
        database.execute("DROP TABLE links")
    assert "can't be read: no such table" in read_page(path, "Events", TIME, 20.0).problem
