"""An order for anyone in the form: the nearest idle robot is shown, asked about, and only then sent."""

from textual.widgets import Input

from tests.support.console_pilot import Console
from tests.support.ordering import order
from tests.support.planted_console import planted


async def empty_robot(it: Console) -> None:
    """Open the form, and empty Robot."""
    await it.press("o", "shift+tab", "delete")


async def test_an_empty_robot_proposes_the_nearest_idle_one_and_asks() -> None:
    async with planted(2, 2) as it:
        await empty_robot(it)
        await it.shows("anyone: the nearest idle robot", "matches")
        await it.press("enter")
        await it.type("Base")
        await it.press("enter")
        await it.shows("robot_0: idle, 0 m from Base, battery ")
        await it.type("Consumidores")
        await it.shows(" m, about ")
        await it.press("enter")
        await it.shows("robot_0 order Base -> Consumidores?")
        await it.shows("Nearest idle, 0 m away")
        assert it.sent == []
        await it.press("y")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores")]
        assert not it.app.main.features.order_form.is_open


async def test_a_busy_robot_is_passed_over_and_no_is_the_default() -> None:
    async with planted(2, 2) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        await it.until(lambda state: state.robots["robot_0"].orders.open)
        await empty_robot(it)
        await it.type("anyone")
        await it.press("enter")
        await it.type("Base")
        await it.press("enter")
        await it.shows("robot_1: idle, ")
        await it.type("Consumidores")
        await it.press("enter")
        await it.shows("robot_1 order Base -> Consumidores?")
        await it.shows("Nearest idle, ")
        await it.press("enter")
        assert it.sent == [order(it, "Base", "Store")], "the first order alone"


async def test_without_an_idle_robot_the_form_says_why() -> None:
    async with planted(2, 2) as it:
        await it.press("P")
        await it.until(lambda state: all(state.is_paused(one) for one in state.robots.values()))
        await empty_robot(it)
        await it.press("enter")
        await it.type("Base")
        await it.shows("no idle robot can reach Base: 2 paused")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        await it.shows("no idle robot can drive Base -> Store: 2 paused")
        assert it.app.main.features.order_form.is_open


async def test_a_robot_named_again_hides_the_proposal() -> None:
    async with planted(2, 2) as it:
        await empty_robot(it)
        await it.press("enter")
        await it.type("Base")
        await it.shows("robot_0: idle, ")
        await it.press("enter", "shift+tab", "shift+tab")
        await it.type("robot_1")
        await it.hides("robot_0: idle, ")
        assert it.app.main.query_one("#robot", Input).value == "robot_1"


async def test_a_name_that_is_no_robot_has_no_places() -> None:
    async with planted(2, 2) as it:
        await empty_robot(it)
        await it.shows("Order for the nearest idle robot")
        await it.type("nobody")
        await it.press("tab")
        await it.type("Base")
        await it.press("enter")
        await it.shows("From: no match for 'Base'")


async def test_anyone_is_typed_in_the_palette_and_asks() -> None:
    async with planted(2, 2) as it:
        await it.press(":")
        await it.type("anyone Base Consumidores")
        await it.shows("nearest idle robot: Base -> Consumidores")
        await it.press("enter")
        await it.shows("robot_0 order Base -> Consumidores?")
        await it.shows("Nearest idle, 0 m away")
        await it.press("y")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base", "Consumidores")]
