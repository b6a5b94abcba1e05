"""The panes share the lines of the screen, and one can have the whole column."""

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of


def heights(it: Console) -> dict[str, int]:
    panes = ("map", "fleet", "alarms", "queue", "page")
    shown = {name: it.app.main.query_one(f"#{name}") for name in panes}
    return {name: pane.size.height for name, pane in shown.items() if pane.display}


async def test_each_pane_has_what_its_rows_need_and_the_robots_page_the_rest(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 12), (120, 40), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        assert heights(it) == {"map": 37, "fleet": 14, "alarms": 3, "queue": 3, "page": 17}
    async with console(config_of(server.url, 12), (80, 24), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        assert heights(it) == {"map": 11, "fleet": 7, "alarms": 3, "queue": 3}


async def test_thirty_robots_have_twenty_four_rows_or_more(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 30), (120, 40), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        assert heights(it)["fleet"] >= 24 + 2


async def test_the_focused_pane_takes_the_column_and_gives_it_back(server: RosbridgeServer) -> None:
    async with console(config_of(server.url, 12), (120, 40), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        before = heights(it)
        await it.press("tab", "=")
        await it.hides("Alarms")
        assert heights(it) == {"map": 37, "fleet": 37}
        await it.press("=")
        await it.shows("Alarms")
        assert heights(it) == before
        await it.press("escape", "=")
        await it.hides("Fleet")
        assert it.app.main.query_one("#map").size.width == 120
        await it.press("=")
        await it.shows("Fleet")
