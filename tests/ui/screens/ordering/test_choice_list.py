"""The list of choices below the fields: by mouse, by arrows, by what was typed last."""

from functools import partial

import pytest
from textual.app import App
from textual.widgets import Input

from fleet_tui.model.fleet import FleetState
from tests.support.console_pilot import Console
from tests.support.ordering import order
from tests.support.planted_console import planted
from tests.support.polling import HANGS


def has_value(it: Console, field: str, _: FleetState) -> bool:
    return it.app.main.query_one(f"#{field}", Input).value != ""


async def test_an_order_by_mouse_alone() -> None:
    async with planted() as it:
        it.app.main.features.orders.start()
        await it.shows("Charger ", "matches")
        await it.settled()
        for field in ("from", "to"):
            rows = it.app.main.query_one("#matches")
            labels = [rows.render_line(y).text for y in range(rows.size.height)]
            wanted = "Base" if field == "from" else "Charger"
            row = next(y for y, text in enumerate(labels) if text.startswith(wanted))
            await it.pilot.click("#matches", offset=(3, row))
            # The list is that of the next field then.
            await it.until(partial(has_value, it, field))
        await it.shows("Enter  send")
        assert it.app.main.query_one("#to", Input).value == "Charger" and it.sent == []
        await it.pilot.click("#send")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Charger")]


async def test_an_arrow_marks_a_choice_where_nothing_is_typed() -> None:
    async with planted() as it:
        await it.press("o", "down")
        await it.shows("Base ", "matches")
        rows = it.app.main.query_one("#matches")
        first = rows.render_line(0).text.partition("  ")[0]
        await it.press("enter")
        await it.type("Consumidores")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, first, "Consumidores")]


async def test_a_double_click_on_a_destination_sends_and_one_on_a_start_does_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # Two clicks at one place are a double one, however busy the machine is.
    monkeypatch.setattr(App, "CLICK_CHAIN_TIME_THRESHOLD", HANGS)
    async with planted() as it:
        it.app.main.features.orders.start()
        await it.shows("Charger ", "matches")
        await it.settled()
        await it.pilot.double_click("#matches", offset=(3, 0))
        await it.until(lambda _: it.app.main.query_one("#from", Input).value)
        assert not it.app.main.query_one("#to", Input).value
        await it.pilot.double_click("#matches", offset=(3, 1))
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert len(it.sent) == 1
