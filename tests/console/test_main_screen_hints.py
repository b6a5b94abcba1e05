"""The footer's hints are pressed with the mouse: each does what its key does."""

import pytest

from fleet_tui.model.commands import PauseRobot
from tests.support.console_pilot import Console
from tests.support.planted_console import planted


async def click_hint(it: Console, hint: str) -> None:
    """Click on the first letter of a hint's label."""
    await it.shows(f" {hint} ", "hints")
    await it.pilot.click("#hints", offset=(it.pane("hints").index(f" {hint} ") + 1, 0))
    await it.settled()


async def test_a_click_on_order_opens_the_form() -> None:
    async with planted(1, 1, (80, 24)) as it:
        await click_hint(it, "order")
        await it.shows("Robot   robot_0")


async def test_a_click_on_pause_commands_the_selected_robot() -> None:
    async with planted(2, 1, (80, 24)) as it:
        await it.press("]")
        await click_hint(it, "pause")
        await it.until(lambda state: state.is_paused(state.robots["robot_1"]))
        assert it.sent == [PauseRobot("robot_1")]
        assert it.app.main.focused is it.app.main.features.map


@pytest.mark.parametrize(("hint", "opens"), [("help", "key_help"), ("command", "palette")])
async def test_the_permanent_hints_open_help_and_palette(hint: str, opens: str) -> None:
    async with planted(1, 1, (60, 24)) as it:
        await click_hint(it, hint)
        assert getattr(it.app.main.features, opens).is_open


async def test_a_hint_of_a_table_is_for_the_row_under_its_cursor() -> None:
    async with planted() as it:
        await it.press("tab")
        await click_hint(it, "menu")
        assert it.app.main.features.menu.is_open


async def test_in_an_overlay_help_and_pause_all_can_be_clicked() -> None:
    async with planted(2) as it:
        await it.press("o")
        await click_hint(it, "pause all")
        await it.until(lambda state: all(state.is_paused(robot) for robot in state.robots.values()))
        assert it.app.main.features.order_form.is_open
        await click_hint(it, "help")
        assert it.app.main.features.key_help.is_open


async def test_a_click_beside_the_hints_does_nothing() -> None:
    async with planted(1, 1, (200, 24)) as it:
        await it.shows(" order ", "hints")
        before = it.pane("hints")
        await it.pilot.click("#hints", offset=(before.index("? help") - 4, 0))
        await it.settled()
        assert it.pane("hints") == before and not it.app.main.features.key_help.is_open
