"""The fleet's rows are made at their pace, and at once when something asks for them."""

import pytest

from fleet_tui.ui.screens.tables import pane_rows
from fleet_tui.ui.widgets import pace
from tests.support.planted_console import planted


async def test_the_fleet_is_the_same_table_until_it_is_due_or_asked_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(3) as it:
        main, now = it.app.main, 1e9
        monkeypatch.setattr(pace, "monotonic", lambda: now)
        first = main.rows.tables()[0]
        assert main.rows.tables()[0] is first
        main.fleet.arrangement.column = "battery"
        sorted_ = main.rows.tables()[0]
        assert sorted_ is not first
        now += 0.3
        assert main.rows.tables()[0] is not sorted_


async def test_the_map_of_a_crowd_is_shown_at_a_pace_and_at_once_for_another_robot(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(2) as it:
        main, now = it.app.main, 1e9
        assert main.rows.is_floor_due(False, None) and main.rows.is_floor_due(False, main.features.map.size)
        monkeypatch.setattr(pane_rows, "CROWD", 2)
        monkeypatch.setattr(pace, "monotonic", lambda: now)
        assert [main.rows.is_floor_due(False, None) for _ in range(3)] == [True, False, False]
        main.navigation.selection = main.navigation.selection.on_robot("robot_1")
        assert [main.rows.is_floor_due(False, None) for _ in range(2)] == [True, False]
        now += 0.3
        assert [main.rows.is_floor_due(False, None) for _ in range(2)] == [True, False]


async def test_the_rows_of_a_crowd_are_not_made_in_one_tick_with_its_map(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(2) as it:
        main, now = it.app.main, 1e9
        monkeypatch.setattr(pane_rows, "CROWD", 2)
        monkeypatch.setattr(pace, "monotonic", lambda: now)
        assert main.rows.is_floor_due(False, None)
        first = main.rows.tables()[0]
        now += 1.0
        assert main.rows.is_floor_due(False, None)
        assert main.rows.tables()[0] is first
        assert not main.rows.is_floor_due(False, None)
        assert main.rows.tables()[0] is not first
        now += 1.0
        assert main.rows.is_floor_due(False, None)
        main.fleet.arrangement.column = "battery"
        assert main.rows.tables()[0] is not first, "at once when asked for"
