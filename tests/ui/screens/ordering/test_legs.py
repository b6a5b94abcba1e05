"""The order form in the states of a robot: the same fields, with a start or of the cargo on board."""

import pytest
from textual.widgets import Input

from fleet_tui.model.events import LabelsReceived
from tests.support.ordering import order
from tests.support.planted_console import planted


async def test_with_cargo_and_no_orders_from_is_here_and_enter_passes_it() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("o")
        await it.shows("Destination of the cargo")
        assert it.app.main.query_one("#from", Input).value == "here"
        await it.press("enter")
        await it.type("Base")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base")]


async def test_another_start_than_here_is_asked_about() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Packing")
        await it.press("enter")
        await it.shows("robot_0 carries cargo: drive to Base first?")
        assert it.sent == []
        await it.press("y")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Packing")]


async def test_cargo_that_came_on_board_meanwhile_is_asked_about() -> None:
    async with planted() as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("enter")
        await it.shows("robot_0 carries cargo: drive to Base first?")
        assert it.sent == []


async def test_cargo_that_left_meanwhile_needs_a_start() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("o", "enter")
        await it.type("Store")
        it.fleet.world.robots["robot_0"].cargo = False
        await it.until(lambda state: not state.robots["robot_0"].has_cargo)
        await it.press("enter")
        await it.shows("From is missing")
        assert it.sent == []


@pytest.mark.parametrize("is_seen_first", [True, False])
@pytest.mark.parametrize("field", ["from", "to"])
async def test_a_place_that_got_another_id_while_the_form_is_open_must_be_chosen_again(
    field: str, is_seen_first: bool
) -> None:
    async with planted() as it:
        ids = it.store.state.robots["robot_0"].maps["floor_0"].labels
        swapped = {"Base": "Packing", "Packing": "Base"}
        await it.press("o")
        await it.type("Base" if field == "from" else "Store")
        await it.press("enter")
        await it.type("Store" if field == "from" else "Base")
        labels = {id_: swapped.get(label, label) for id_, label in ids.items()}
        it.store.apply(LabelsReceived("robot_0", "floor_0", labels))
        if is_seen_first:
            await it.shows("Base: changed meanwhile, choose again")
        await it.press("enter")
        await it.shows("Base: changed meanwhile, choose again")
        assert it.sent == []


async def test_notices_of_the_form_are_those_of_now() -> None:
    async with planted() as it:
        await it.press("o")
        it.fleet.world.robots["robot_0"].battery = 5.9
        await it.shows("battery 5 %", "condition")
        await it.shows("Base -> Charger  (charge)", "matches")
        it.fleet.world.robots["robot_0"].paused = True
        await it.shows("battery 5 %, paused (elsewhere)", "condition")
        it.fleet.world.robots["robot_0"].paused = False
        it.fleet.world.robots["robot_0"].battery = 80.0
        await it.hides("battery 5 %", "order-form")
        await it.hides("(charge)", "order-form")
