"""Typed commands, chains, again and back: what is asked, what is refused, what reaches the wire."""

import pytest
from msgspec.structs import replace
from textual.widgets import Input

from fleet_tui.commands import checks
from fleet_tui.model.commands import CancelOrder, PauseRobot
from fleet_tui.model.problem import Permissions
from fleet_tui.robots.profile import Profile
from fleet_tui.ui.screens.ordering.form import OrderForm
from fleet_tui.ui.screens.palette import Palette
from tests.support.console_pilot import Console
from tests.support.console_trips import trips
from tests.support.ordering import one_packet, order, place
from tests.support.planted_console import SITE, planted
from tests.support.watched_store import config_of


def request(it: Console) -> str:
    """The line of the palette as it is typed so far."""
    return it.app.main.query_one("#request", Input).value


async def test_a_typed_order_is_the_first_entry_and_enter_sends_it() -> None:
    async with planted() as it:
        await it.press("colon")
        await it.type("robot_0 base > consumidores")
        await it.shows("robot_0 order Base -> Consumidores")
        await it.press("enter")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores"])


async def test_a_command_in_one_packet_asks_once_and_only_y_does_it() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("Base -> Consumidores", "queue")
        for line in (":cancel 1\r", ":clear robot_0\r"):
            one_packet(it, line)
            await it.shows("y  Yes")
            one_packet(it, "\r")
            await it.hides("y  Yes")
        assert len(it.sent) == 1
        one_packet(it, ":cancel 1\ry")
        await it.shows("1 key dropped, typed on after Enter")
        await it.shows("y  Yes")
        assert len(it.sent) == 1
        await it.press("y")
        await it.until(lambda state: not state.robots["robot_0"].orders.orders)
        assert it.sent[-1] == CancelOrder("robot_0", "1")


async def test_pause_all_typed_never_asks() -> None:
    async with planted(2, 2) as it:
        one_packet(it, ":pause all\r")
        await it.until(lambda _: it.sent == [PauseRobot("robot_0"), PauseRobot("robot_1")])


async def test_what_is_wrong_with_a_line_is_said_and_nothing_is_sent() -> None:
    async with planted() as it:
        await it.press("colon")
        await it.type("robot_0 Base > Consumidor3s")
        await it.shows("robot_0 has no place 'Consumidor3s', did you mean Consumidores?")
        await it.press("enter")
        assert it.app.main.query_one(Palette).is_open
        await it.press("escape")
        for line, said in (
            (":cancel 99\r", "not sent: order 99 is not in the queue of robot_0"),
            (":cancel 0\r", "not sent: order id 0 means all orders to the robot: use clear instead"),
            (":robot_0 Base > Base\r", "not sent: From and To are the same place: Base"),
            (":order robot_0 Base 77\r", "not sent: robot_0 has no vertex 77"),
            (":order robot_0 Base\r", "not sent: robot_0 has no cargo on board"),
        ):
            one_packet(it, line)
            await it.shows(said)
        assert it.sent == []


async def test_what_means_nothing_is_said_to() -> None:
    async with planted() as it:
        await it.press("colon")
        await it.type("qqqq")
        await it.shows("no match for qqqq")
        await it.press("enter")
        await it.shows("no match for qqqq")


async def test_tab_completes_what_is_typed() -> None:
    async with planted() as it:
        one_packet(it, ":ro\tbas\t\tcons\t")
        await it.until(lambda _: request(it) == "robot_0 Base > Consumidores ")
        one_packet(it, "\r")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores"])


async def test_tab_goes_through_what_a_word_can_become() -> None:
    async with planted(2, 2) as it:
        field = it.app.main.query_one("#request", Input)
        for keys, line in ((":pause \t", "pause all"), ("\t", "pause robot_0"), ("\t\t", "pause all")):
            one_packet(it, keys)
            await it.until(lambda _, line=line: field.value == line)  # type: ignore[misc]  # bound now
        await it.shows("pause all")


async def test_a_line_of_the_list_goes_on_typing() -> None:
    async with planted() as it:
        one_packet(it, ":robot_0 Base > Cons\r")
        await it.until(lambda _: request(it) == "robot_0 Base > Consumidores ")
        assert it.app.main.query_one(Palette).is_open
        one_packet(it, "\r")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores"])


async def test_a_sign_after_a_label_adds_a_leg() -> None:
    async with planted() as it:
        one_packet(it, "oBase>Cons>Store\r")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores", "Consumidores -> Store"])
        assert not it.app.main.query_one(OrderForm).is_open


async def test_a_leg_can_be_taken_back() -> None:
    async with planted() as it:
        one_packet(it, "oBase\rCons>")
        await it.shows("Consumidores > ")
        await it.press("enter")
        await it.shows("To is missing")
        await it.press("backspace", "enter")
        await it.until(lambda _: trips(it) == ["Base -> Consumidores"])


async def test_the_last_destination_comes_first() -> None:
    async with planted() as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        await it.press("enter")
        await it.until(lambda _: trips(it) == ["Base -> Store"])
        await it.press("o")
        await it.type("Receiving")
        await it.press("enter")
        await it.until(lambda _: it.pane("matches").startswith("Store "))
        await it.press("enter")
        await it.shows("To is missing")
        await it.press("down", "enter")
        await it.until(lambda _: trips(it)[1:] == ["Receiving -> Store"])


async def test_the_same_order_again_at_once_is_a_slip(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checks, "SAME_WITHIN", 600.0)
    async with planted() as it:
        one_packet(it, "oBase\rCons\r")
        one_packet(it, "oBase\rCons\r")
        await it.shows("not sent: same order sent ")
        one_packet(it, "\x1bp")
        await it.until(lambda _: len(it.sent) == 2)
        assert it.sent == [order(it, "Base", "Consumidores"), PauseRobot("robot_0")]


async def test_a_chain_may_have_an_order_twice_and_others_are_no_slip() -> None:
    async with planted() as it:
        one_packet(it, "oBase>Store>Base>Store\r")
        one_packet(it, "oStore\rBase\r")
        back, forth = "Store -> Base", "Base -> Store"
        await it.until(lambda _: trips(it) == [forth, back, forth, back])


async def test_again_and_the_way_back_by_the_menu_of_an_order() -> None:
    async with planted() as it:
        await place(it)
        await it.shows("confirmed (seen in the queue as order 1)")
        await it.press("shift+tab", "enter")
        await it.shows("Order 1 of robot_0: Base -> Consumidores")
        await it.shows("sent here at")
        assert ", accepted, confirmed" in it.text
        await it.press("3")
        await it.until(lambda _: trips(it)[1:] == ["Consumidores -> Base"])
        await it.until(lambda _: len(it.store.state.robots["robot_0"].orders.orders) == 2)
        it.app.main.dispatch.given.clear()  # more than a second later
        await it.press("enter", "2")
        await it.until(lambda _: trips(it)[2:] == ["Base -> Consumidores"])


async def test_an_order_of_another_console_is_not_ours() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].take(0, 5, 77)
        await it.shows("1 order", "queue")
        await it.press("shift+tab", "enter")
        await it.shows("not sent by this console")


async def test_a_read_only_console_says_so_in_the_form() -> None:
    async with planted() as it:
        it.app.main.dispatch.permissions = Permissions(read_only=True)
        await place(it)
        await it.shows("this console is read-only", "missing")
        it.app.main.dispatch.permissions = Permissions(armed=False)
        await it.press("enter")
        await it.shows("this console is not armed", "missing")
        assert it.sent == []


async def test_no_order_leaves_through_a_dead_link_and_the_form_says_why() -> None:
    async with planted() as it:
        it.lose_link()
        await it.shows("no link")
        await place(it)
        await it.shows("not sent: robot_0 is unreachable", "missing")
        assert it.store.state.commands == ()


async def test_with_cargo_a_chain_begins_with_the_cargo() -> None:
    async with planted() as it:
        it.fleet.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        one_packet(it, "o\rBase>Store\r")
        await it.until(lambda state: len(state.commands) == 2 and state.commands[-1].is_decided)
        assert it.sent == [order(it, "Base"), order(it, "Base", "Store")]


@pytest.mark.parametrize("size", [(120, 40), (80, 24)])
async def test_an_action_is_listed_with_its_key_and_beginnings_of_words_come_first(
    size: tuple[int, int],
) -> None:
    async with planted(1, 1, size) as it:
        await it.press("colon")
        await it.type("cen")
        await it.shows("Toggle the zoom centre", "requests")
        rows = [row.split() for row in it.pane("requests").splitlines()]
        assert [(row[0], row[-1]) for row in rows] == [("Centre", "c"), ("Toggle", "z")]
        assert len({len(row.rstrip()) for row in it.pane("requests").splitlines()}) == 1, "one column"


@pytest.mark.parametrize(
    ("typed", "found"),
    [("exit", "Quit"), ("halt", "Pause all robots immediately"), ("stuck", "Explain why"), ("got", "goto")],
)
async def test_words_that_people_bring_find_actions_and_the_beginning_of_a_verb_its_verb(
    typed: str, found: str
) -> None:
    profile = Profile(topics={"goal": "/{robot}/goal"})
    async with planted(config=replace(config_of(SITE, 1), profile=profile)) as it:
        await it.press("colon")
        await it.type(typed)
        await it.shows(found, "requests")
