"""Robots that can't be asked everything: what is hidden, what is answered, and who is paused all the same."""

import pytest

from fleet_tui.model.commands import PauseRobot, PlaceOrder
from fleet_tui.model.order import at_vertices
from fleet_tui.text.language import Message
from tests.support.made_up_kind import mixed
from tests.support.ordering import vertex
from tests.support.planted_console import SITE, planted


async def test_pause_all_reaches_who_can_be_paused_and_names_who_can_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(config=mixed(monkeypatch, SITE, 1)) as it:
        said, note = list[str](), it.app.main.notices.note

        def listen(text: Message, stays: bool = False) -> None:
            said.append(text)
            note(text, stays)

        monkeypatch.setattr(it.app.main.notices, "note", listen)
        await it.press("P")
        # The robot's confirmation, which takes its place, may come at once.
        await it.until(lambda _: any("robot_1: this kind has no pause" in text for text in said))
        await it.until(lambda state: state.robots["robot_0"].paused and state.robots["robot_0"].paused.value)
        assert it.sent == [PauseRobot("robot_0")]


async def test_a_key_that_the_kind_has_nothing_for_says_so_and_is_not_hinted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(config=mixed(monkeypatch, SITE, 0)) as it:
        await it.shows(" o order", "hints")
        assert " p pause" not in it.pane("hints") and " P pause all" in it.pane("hints")
        await it.press("p")
        await it.shows("not sent: robot_0: this kind has no pause", "message")
        await it.press("X")
        await it.shows("not sent: robot_0: this kind has no clear", "message")
        await it.press("right_square_bracket")
        await it.shows(" p pause", "hints")
        assert it.sent == []


async def test_the_palette_offers_what_can_be_done_and_answers_what_is_typed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with planted(config=mixed(monkeypatch, SITE, 0)) as it:
        await it.press("colon")
        await it.type("selected robot")
        await it.shows("Open the order form for the selected robot")
        assert "Pause the selected robot" not in it.text
        await it.press("escape", "colon")
        await it.type("pause robot_0")
        await it.shows("robot_0: this kind has no pause")
        assert it.sent == []


async def test_the_menu_of_a_robot_has_what_it_accepts(monkeypatch: pytest.MonkeyPatch) -> None:
    async with planted(config=mixed(monkeypatch, SITE, 0)) as it:
        await it.press("tab", "enter")
        await it.shows("Show on the map")
        assert "Order" in it.text and "Resume" not in it.text and "Clear all orders" not in it.text


async def test_an_order_without_cargo_needs_no_from(monkeypatch: pytest.MonkeyPatch) -> None:
    async with planted(config=mixed(monkeypatch, SITE, 0)) as it:
        await it.press("o", "enter")
        await it.type("Consum")
        await it.press("enter")
        await it.shows("robot_0 go to Consumidores", "message")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert it.sent == [PlaceOrder("robot_0", at_vertices(str(vertex(it, "Consumidores"))))]
