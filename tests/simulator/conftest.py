"""Fixtures of the simulator's tests."""

from collections.abc import AsyncIterator

import pytest
from websockets.asyncio.client import ClientConnection, connect

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.nav2_site import LONG_AGO


@pytest.fixture
def world() -> OhFleet:
    """One quiet robot on two floors."""
    return OhFleet(1, 2, seed=3, quiet=True)


@pytest.fixture
def robot(world: OhFleet) -> SimRobot:
    """The robot of that world."""
    return world.robots["robot_0"]


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    """Two quiet simulated robots on two floors, at 50 Hz."""
    server = RosbridgeServer(OhFleet(2, 2, seed=1, quiet=True), rate=50.0)
    await server.start()
    yield server
    await server.stop()


@pytest.fixture
async def three() -> AsyncIterator[RosbridgeServer]:
    """Three quiet simulated robots on two floors, at 20 Hz."""
    server = RosbridgeServer(OhFleet(3, 2, seed=1, quiet=True), rate=20.0)
    await server.start()
    yield server
    await server.stop()


@pytest.fixture
async def ros2_server() -> AsyncIterator[RosbridgeServer]:
    """Three quiet simulated robots behind a bridge on ROS 2 that has discovered every publisher."""
    server = RosbridgeServer(OhFleet(3, 2, seed=1, quiet=True), rate=20.0, dialect=ROS2)
    await server.start()
    server.bridge.started -= LONG_AGO
    yield server
    await server.stop()


@pytest.fixture
async def client(server: RosbridgeServer) -> AsyncIterator[ClientConnection]:
    """A client of it."""
    async with connect(server.url, max_size=None, close_timeout=0.1) as client:
        yield client


@pytest.fixture
async def other(server: RosbridgeServer) -> AsyncIterator[ClientConnection]:
    """Another one."""
    async with connect(server.url, max_size=None, close_timeout=0.1) as client:
        yield client
