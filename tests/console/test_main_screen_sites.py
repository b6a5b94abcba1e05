"""Two sites in one console: one is shown, the alarms of both are in the top line."""

from collections.abc import AsyncIterator

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import console
from tests.support.sites import config_of_sites


@pytest.fixture
async def north() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(OhFleet(robots=3, floors=1, quiet=True))
    await running.start()
    yield running
    await running.stop()


@pytest.fixture
async def south() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(OhFleet(robots=2, floors=2, quiet=True))
    await running.start()
    yield running
    await running.stop()


async def test_a_typed_site_is_shown_alone_and_alarms_of_all_are_counted(
    north: RosbridgeServer, south: RosbridgeServer
) -> None:
    config = config_of_sites(Link(north.url, site="north"), Link(south.url, site="south"))
    async with console(config, (120, 40), wait=False) as it:
        await it.until(lambda _: it.app.main.is_complete)
        await it.shows("2 of 2 online", "fleet")
        await it.shows("north: robot_0")
        assert "robot_1" not in it.pane("fleet")
        await it.press("]", "]")
        await it.shows("north: robot_0")
        await it.type(":site south")
        await it.press("enter")
        await it.shows("1 of 1 online", "fleet")
        await it.shows("south: robot_1")
        await it.shows("─ floor_1 ", "map")
        await it.press(">")
        await it.shows("─ floor_1 ", "map")
        await south.stop()
        await it.type(":robot_0")
        await it.press("enter")
        await it.shows("north: robot_0")
        await it.shows("alarm (1 new): south 1")
        await it.shows("all clear", "alarms")
        await it.type(":site south")
        await it.press("enter")
        await it.shows("south: robot_1")
        await it.shows("no link", "alarms")
