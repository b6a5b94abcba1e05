"""Fixtures that several rooms share."""

import signal
from collections.abc import AsyncIterator, Iterator

import pytest
from hypothesis import settings

from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.terminal import fault_guard

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


@pytest.fixture(autouse=True)
def no_own_faults(request: pytest.FixtureRequest, caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    """What the console survives of its own faults would go unseen here."""
    yield
    if request.node.get_closest_marker("own_faults") is None:
        records = caplog.get_records("call")
        faults = [record for record in records if record.name == fault_guard.__name__]
        assert not faults, [record.exc_text or record.getMessage() for record in faults]
