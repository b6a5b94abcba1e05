"""Moments and seconds of a history."""

from contextlib import closing
from io import StringIO
from pathlib import Path

import msgspec

from fleet_tui.features.history.cli.printing import as_json, iso, moment, write_text
from fleet_tui.model.history.facts import Activity, Span
from fleet_tui.records.history.database import open_to_write
from fleet_tui.records.history.observing import HOUR
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.tables import write


def test_times_are_local() -> None:
    assert iso(None) == "" and len(iso(1e9)) == len("2001-09-09T01:46:40+00:00")
    assert len(moment(1e9)) == len("09-09 01:46:40")


def test_an_empty_time_says_so() -> None:
    said = StringIO()
    write_text([], 1e9, said)
    assert said.getvalue() == f"nothing happened since {moment(1e9)}\n"


def test_days_are_summed_by_hours(tmp_path: Path) -> None:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        for hour in range(60):
            span = Span("robot_0", Activity.DRIVING, hour * HOUR, hour * HOUR + 60, "floor_0")
            write(database, span, "run1", "ana")
        for until, seconds in ((10 * HOUR, 600.0), (60 * HOUR, 3600.0)):
            told = msgspec.json.decode(as_json(History(database), [], 0.0, until, ""))
            assert told["robots"] == {"robot_0": {"driving": seconds}}


def test_json_is_ascii_whatever_robots_said(tmp_path: Path) -> None:
    database, _ = open_to_write(tmp_path / "a.sqlite")
    with closing(database):
        write(database, Span("robot\x9b2J\u202e", Activity.DRIVING, 0.0, 60.0, "floor_0"), "run1", "ana")
        told = as_json(History(database), [], 0.0, 100.0, "")
    assert told.isascii() and "\\u009b2J\\u202e" in told
