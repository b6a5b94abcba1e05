"""Fixtures that several rooms share."""

import signal
from collections.abc import AsyncIterator

import pytest
from hypothesis import settings

from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.world import World

# In the background of a shell SIGINT is ignored; programs that a test interrupts would inherit that.
signal.signal(signal.SIGINT, signal.default_int_handler)

# How long an example takes on a busy machine says nothing; what hangs meets pytest's own timeout.
settings.register_profile("fleet-tui", deadline=None)
settings.load_profile("fleet-tui")


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    """Two quiet simulated robots on two floors behind a real server."""
    running = RosbridgeServer(World(robots=2, floors=2, seed=1, quiet=True))
    await running.start()
    yield running
    await running.stop()
