"""Situations on a console's screen."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console, console
from tests.support.watched_store import config_of


@asynccontextmanager
async def in_the_way(server: RosbridgeServer, *names: str) -> AsyncIterator[Console]:
    """A console with robots that touch something for 4.2 s."""
    server.bridge.muted.update(f"/{name}/obstacle" for name in names)
    async with console(config_of(server.url, 2, 2)) as it:
        for name in names:
            server.bridge.publish_raw(f"/{name}/obstacle", {"data": 44.2})
        await it.shows(f"Alarms {len(names)} new", "alarms")
        yield it
