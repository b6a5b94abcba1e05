"""Legs of the order form: with a start, or of the cargo on board."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import sent, vertex
from tests.support.watched_store import config_of


async def test_with_cargo_and_no_orders_there_is_only_a_destination(server: RosbridgeServer) -> None:
    server.world.robots["robot_0"].cargo = True
    async with console(config_of(server.url, 1)) as it:
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("o")
        await it.shows("Destination of the cargo")
        assert "From" not in it.text
        await it.type("Base")
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        wanted = {"agent": "robot_0", "end_point": vertex(it, "Base")}
        assert sent(server) == [("Execute_order_with_cargo", wanted)]


async def test_cargo_that_came_on_board_meanwhile_changes_the_form_not_the_command(
    server: RosbridgeServer,
) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("o")
        await it.type("Base")
        await it.press("enter")
        await it.type("Store")
        server.world.robots["robot_0"].cargo = True
        await it.until(lambda state: state.robots["robot_0"].has_cargo)
        await it.press("enter")
        await it.shows("now has cargo and no orders")
        assert sent(server) == []
        await it.press("enter")
        await it.until(lambda state: state.commands and state.commands[-1].is_decided)
        assert [name for name, _ in sent(server)] == ["Execute_order_with_cargo"]
