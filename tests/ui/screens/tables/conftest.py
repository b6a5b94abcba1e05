"""Three robots: two of them can be marked, and one left out."""

from collections.abc import AsyncIterator

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    running = RosbridgeServer(OhFleet(robots=3, floors=2, seed=1, quiet=True))
    await running.start()
    yield running
    await running.stop()
