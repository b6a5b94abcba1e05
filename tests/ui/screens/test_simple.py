"""The simple interface: an order with arrows and Enter alone, or with the mouse alone."""

import pytest

from fleet_tui.model.events import LabelsReceived
from tests.support.console_pilot import Console
from tests.support.ordering import order, vertex
from tests.support.planted_console import planted


async def pick_by_arrows(it: Console, label: str) -> None:
    """Down to a label of the list that is open, and Enter."""
    field = it.app.main.query_one("#simple-typed")
    await it.until(lambda _: it.app.main.focused is field)
    await it.shows(label, "simple-list")
    lines = [line.strip() for line in it.pane("simple-list").splitlines()]
    at = next(n for n, line in enumerate(lines) if line.startswith(label))
    await it.press(*["down"] * at, "enter")


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_an_order_with_arrows_and_enter_alone(size: tuple[int, int]) -> None:
    async with planted(2, 1, size) as it:
        await it.press("s")
        await it.shows("Robot: robot_0")
        for word in ("● ws://", "Queue robot_0", "Alarms", "robot_1", "Send"):
            await it.shows(word)
        await it.press("up", "enter")
        await it.shows("Which robot?")
        await pick_by_arrows(it, "robot_1")
        await it.shows("Robot: robot_1")
        await it.press("enter")
        await it.shows("From where?")
        await pick_by_arrows(it, "Base")
        await it.shows("From: Base")
        await it.press("enter")
        await it.shows("Where to?")
        await pick_by_arrows(it, "Consumidores")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores", robot="robot_1")]
        await it.shows("Base -> Consumidores", "queue")
        await it.shows("From: choose")


@pytest.mark.parametrize("size", [(60, 15), (45, 12), (120, 15)])
async def test_on_a_small_terminal_the_form_works_with_the_worst_alarm_in_view(size: tuple[int, int]) -> None:
    async with planted(2) as it:
        await it.pilot.resize_terminal(*size)
        it.fleet.world.robots["robot_1"].battery = 5.0
        await it.until(lambda state: state.unacknowledged)
        await it.press("s")
        for word in ("Robot: robot_0", "From: choose", "To: choose", "Send", "▲ new", "robot_1"):
            await it.shows(word)
        assert " menu " not in it.pane("hints")
        for label in ("Base", "Consumidores"):
            await it.press("enter")
            await pick_by_arrows(it, label)
        await it.shows("To: Consumidores")
        assert "▲ new" in it.text
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores")]
        await it.press("s")
        await it.shows(" 0 robot_0")


async def test_an_order_with_the_mouse_alone() -> None:
    async with planted() as it:
        await it.press("s")
        await it.shows("From: choose")
        for button, row in (("#simple-from", 0), ("#simple-to", 2)):
            await it.pilot.click(button)
            await it.until(lambda _: it.app.main.query_one("#simple-list").region.height)
            await it.pilot.click("#simple-list", offset=(3, row))
            await it.until(lambda _: it.app.main.query_one("#simple-send").region.height)
        await it.pilot.click("#simple-send")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores")]


async def test_what_is_missing_is_named_and_nothing_leaves() -> None:
    async with planted() as it:
        await it.press("s", "down", "down", "enter")
        await it.shows("From is missing")
        await it.press("enter")
        await pick_by_arrows(it, "Base")
        await it.press("down", "enter")
        await it.shows("To is missing")
        await it.press("enter")
        await pick_by_arrows(it, "Base")
        await it.press("enter")
        await it.shows("same place")
        assert it.sent == []


async def test_with_cargo_on_board_the_order_starts_here_and_the_buttons_stay() -> None:
    async with planted() as it:
        await it.press("s")
        await it.shows("From: choose")
        it.fleet.world.robots["robot_0"].cargo = True
        await it.shows("To, for the cargo on board")
        await it.shows("From: here")
        await it.press("down", "enter")
        await it.shows("Where to?")
        await pick_by_arrows(it, "Base")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base")]


async def test_a_label_that_looks_like_markup_is_text() -> None:
    async with planted() as it:
        it.store.apply(LabelsReceived("robot_0", "floor_0", {"0": "[bold]Base[/]"}))
        await it.press("s")
        await it.shows("From: choose")
        await it.press("enter")
        await it.shows("[bold]Base[/]  (floor_0)")
        await it.press("enter")
        await it.shows("From: [bold]Base[/]")


async def test_a_list_filters_as_one_types_and_no_letter_commands() -> None:
    async with planted(2) as it:
        await it.press("s", "down", "enter")
        await it.shows("Where to?")
        await it.type("Pack")
        await it.shows("Packing  (floor_0)", "simple-list")
        await it.hides("Base", "simple-list")
        await it.press("enter")
        await it.shows("To: Packing")
        assert it.sent == []


async def test_what_was_chosen_is_forgotten_when_it_is_left() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("s", "enter")
        await it.type("Base")
        await it.press("enter")
        await it.shows("To, for the cargo on board: Base")
        for leave in ("escape", "s"):
            await it.press(leave, "s", "enter")
            await it.shows("Where to?")
            await it.press("escape")
            await it.shows("To, for the cargo on board: choose")
        assert it.sent == []


async def test_a_place_that_got_another_id_meanwhile_must_be_chosen_again() -> None:
    async with planted() as it:
        base = str(vertex(it, "Base"))
        await it.press("s", "enter")
        await it.type("Base")
        await it.press("enter")
        await it.shows("From: Base")
        it.store.apply(
            LabelsReceived("robot_0", "floor_0", {base: "Depot", "0" if base != "0" else "1": "Base"})
        )
        await it.shows("Base: changed meanwhile, choose again")
        await it.shows("From: choose")
