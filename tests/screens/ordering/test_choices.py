"""Choices of the order form: places of the robot it is for."""

import msgspec
from textual.widgets import Input

from fleet_tui.screens.ordering.form import OrderForm
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import place, sent, vertex
from tests.support.watched_store import config_of


async def test_an_order_from_a_vertex_on_the_map(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("n", "n", "enter")
        await it.shows("Order")
        start = it.app.main.query_one("#from", Input).value
        await it.type("Consum")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        ids = {"initial_point": vertex(it, start), "end_point": vertex(it, "Consumidores")}
        assert sent(server) == [("Execute_order", ids)]


async def test_with_cargo_a_vertex_on_the_map_is_where_it_goes(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("n", "n", "enter")
        await it.shows("Destination of the cargo")
        end = it.app.main.query_one("#to", Input).value
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert sent(server)[0][1]["end_point"] == vertex(it, end)


async def test_another_robot_in_the_form_means_other_ids(server: RosbridgeServer) -> None:
    """A choice for one robot is not sent to another: each has a graph of its own."""
    async with console(config_of(server.url, 2, 2)) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter", "shift+tab", "shift+tab", "end", "backspace", "1", "tab", "tab")
        await it.type("Store")
        await it.press("enter")
        await it.shows("From: Enter takes the marked place")
        assert sent(server) == []


async def test_a_vertex_that_the_robot_does_not_know_opens_no_form(server: RosbridgeServer) -> None:
    config = config_of(server.url, 2, 2)
    first, second = config.robots
    only_below = msgspec.structs.replace(first, floors=["floor_0"])
    async with console(msgspec.structs.replace(config, robots=[only_below, second])) as it:
        await it.press("}", "n", "n", "enter")
        await it.shows("has no vertex")
        assert not it.app.main.query_one(OrderForm).is_open


async def test_an_order_is_given_again_by_an_arrow_and_two_enters(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 2, 2)) as it:
        await place(it)
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        server.bridge.services.calls.clear()
        await it.press("2", "o")
        await it.shows("Base -> Consumidores  (last)", "matches")
        await it.press("down")
        await it.shows(" m, about ")
        await it.press("enter")
        await it.shows("Enter  send")
        assert it.app.main.query_one("#to", Input).value == "Consumidores"
        assert sent(server) == []
        await it.press("enter")
        await it.until(lambda _: sent(server))
        start, end = vertex(it, "Base"), vertex(it, "Consumidores")
        assert sent(server) == [("Execute_order", {"initial_point": start, "end_point": end})]


async def test_favourites_leave_when_a_label_is_typed(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await place(it)
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        await it.press("o")
        await it.shows("(last)", "matches")
        await it.type("Ba")
        await it.hides("(last)", "matches")
