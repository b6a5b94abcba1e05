"""Tests of robots/vda5050/messages."""

from datetime import UTC, datetime

import pytest

from fleet_tui.robots.vda5050.messages import unix_second

SECOND = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC).timestamp()


@pytest.mark.parametrize(
    ("text", "after"),
    [
        ("2026-01-02T03:04:05Z", 0.0),
        ("2026-01-02T03:04:05.5Z", 0.5),
        ("2026-01-02T03:04:05.678", 0.678),
        ("2026-01-02T04:04:05+01:00", 0.0),
        ("2026-01-02T01:04:05-0200", 0.0),
    ],
)
def test_the_ways_in_which_vehicles_write_a_time(text: str, after: float) -> None:
    assert unix_second(text) == pytest.approx(SECOND + after)


@pytest.mark.parametrize("text", ["", "now", "2026-13-02T03:04:05Z", "2026-01-02", "0000-01-02T03:04:05Z"])
def test_other_texts_are_none(text: str) -> None:
    assert unix_second(text) is None
