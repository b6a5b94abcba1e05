"""A server with two robots with Nav2, long up."""

from collections.abc import AsyncIterator

import pytest

from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer

LONG_AGO = 10.0  # seconds: such a bridge has discovered every publisher


@pytest.fixture
def fleet() -> Nav2Fleet:
    return Nav2Fleet(2, 1, seed=1, quiet=True)


@pytest.fixture
async def server(fleet: Nav2Fleet) -> AsyncIterator[RosbridgeServer]:
    server = RosbridgeServer(fleet, rate=50.0, speed=20.0, dialect=ROS2)
    await server.start()
    server.bridge.started -= LONG_AGO
    yield server
    await server.stop()
