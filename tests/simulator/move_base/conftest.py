"""A server with two robots with move_base."""

from collections.abc import AsyncIterator

import pytest

from fleet_tui.simulator.move_base.fleet import MoveBaseFleet
from fleet_tui.simulator.server import RosbridgeServer


@pytest.fixture
def fleet() -> MoveBaseFleet:
    return MoveBaseFleet(2, 1, seed=1, quiet=True)


@pytest.fixture
async def server(fleet: MoveBaseFleet) -> AsyncIterator[RosbridgeServer]:
    server = RosbridgeServer(fleet, rate=50.0, speed=20.0)
    await server.start()
    yield server
    await server.stop()
