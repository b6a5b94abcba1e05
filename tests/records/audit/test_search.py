"""Typed searches for records, and their export to a spreadsheet."""

from datetime import UTC, datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.export import COLUMNS
from fleet_tui.records.audit.search import moment, search_of
from fleet_tui.text.errors import FleetError
from tests.support.fleets import WALL
from tests.support.records import record

NOW = datetime.fromtimestamp(WALL, UTC) + timedelta(hours=3)
REFUSED = record("no way", change="refused", what="order", start="1", start_label="Base", end="3", id=42)


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("", True),
        ("BASE -> 3", True),
        ("base store", False),
        ("robot:robot_0", True),
        ("robot:robot", False),
        ("by:ana no way", True),
        ("by:eva", False),
        ("outcome:refused", True),
        ("outcome:ref", True),
        ("outcome:not-sent", False),
        ("request:42", True),
        ("request:4", False),
        ("since:4h", True),
        ("since:2h", False),
        ("until:2h", True),
        ("until:4h", False),
        ("since:2020-01-01 until:2020-01-02", False),
        ("nothing:like", False),
        ("robot:", False),
    ],
)
def test_a_search_finds_what_was_typed(typed: str, found: bool) -> None:
    assert search_of(typed, NOW).wants(REFUSED) is found


def test_what_the_demo_did_is_apart() -> None:
    assert not search_of("", NOW, demo=True).wants(REFUSED)
    demo = AuditRecord(**{**{name: getattr(REFUSED, name) for name in COLUMNS}, "demo": True})
    assert search_of("", NOW, demo=True).wants(demo) and not search_of("", NOW).wants(demo)


def test_times_are_local_unless_they_say_otherwise() -> None:
    assert moment("30m", NOW) == NOW - timedelta(minutes=30)
    assert moment("9:05", NOW) == NOW.replace(hour=9, minute=5, second=0, microsecond=0)
    assert moment("2024-05-31T12:00+02:00", NOW) == datetime(2024, 5, 31, 10, tzinfo=UTC)
    assert moment("2024-05-31", NOW) == datetime(2024, 5, 31).astimezone()


@pytest.mark.parametrize("text", ["2x", "25:00", "yesterday", "999999d", "2024-13-01", "0001-01-01"])
def test_a_time_that_is_none_is_answered_with_the_forms(text: str) -> None:
    with pytest.raises(FleetError, match="use 30m, 2h, 7d"):
        search_of(f"since:{text}", NOW)


@given(st.text(max_size=30), st.text(max_size=10))
def test_no_search_fails_on_any_record(typed: str, time: str) -> None:
    odd = AuditRecord(**{**{name: getattr(REFUSED, name) for name in COLUMNS}, "time": time})
    try:
        search = search_of(typed, NOW)
    except FleetError:
        return
    search.wants(odd)
    search_of("since:2h", NOW).wants(odd)
