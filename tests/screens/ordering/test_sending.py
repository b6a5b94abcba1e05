"""From filled fields to an order: the first field that lacks a place is named."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.ordering import sent
from tests.support.watched_store import config_of


async def test_what_is_missing_is_named(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 1)) as it:
        await it.press("o", "enter")
        await it.shows("From is missing")
        await it.type("zzz")
        await it.press("enter")
        await it.shows("no match for 'zzz'")
        await it.press("escape", "o")
        await it.type("Base")
        await it.press("enter", "enter")
        await it.shows("To is missing")
        await it.type("Base")
        await it.press("enter")
        await it.shows("same place")
        await it.press("escape")
        await it.hides("To is missing")
        assert sent(server) == []
