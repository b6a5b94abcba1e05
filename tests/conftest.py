"""Fixtures that several packages' tests share."""

import gc
import os
import signal
from collections.abc import AsyncIterator, Iterator
from pathlib import Path
from zlib import crc32

import pytest
from hypothesis import settings

from fleet_tui.links import memory
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.terminal import fault_guard
from tests.support.cli import config_file
from tests.support.nav2_site import Site, nav2_site
from tests.support.parsed_styles import parse_styles_once

# In the background of a shell SIGINT is ignored, under nohup SIGHUP: what a test starts would inherit that.
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGHUP, signal.SIG_DFL)

# How long an example takes on a busy machine says nothing; what hangs meets pytest's own timeout.
# The same few examples each time, so that a failure is the change's; more and others find more:
# FLEET_TUI_EXAMPLES=2000 make quick.
MORE_EXAMPLES = int(os.environ.get("FLEET_TUI_EXAMPLES", "0"))
settings.register_profile(
    "fleet-tui", deadline=None, max_examples=MORE_EXAMPLES or 20, derandomize=not MORE_EXAMPLES
)
settings.load_profile("fleet-tui")

parse_styles_once()

# It is for the life of a console, and a process here lives for thousands of tests: fresh pages for each array
# would take a seventh of the run.
memory.tune_malloc = lambda: None

LONGEST = ("test_soak.py", "test_main_fuzz.py", "test_process.py", "test_running.py", "test_real_keys.py")
"""They begin first: whoever ran one of them at the end would run alone."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    # Files that wait among files that compute: by folders the cores idle first and are too few later.
    items.sort(key=lambda item: (item.path.name not in LONGEST, crc32(bytes(item.path))))


def pytest_collection() -> None:
    gc.disable()  # what is collected stays: to search it for garbage takes a sixth of the time


def pytest_collection_finish() -> None:
    gc.enable()
    gc.freeze()  # going through all tests and modules for garbage takes a fifth of the run


@pytest.fixture
async def server() -> AsyncIterator[RosbridgeServer]:
    """Two quiet simulated robots on two floors behind a real server."""
    running = RosbridgeServer(OhFleet(robots=2, floors=2, seed=1, quiet=True))
    await running.start()
    yield running
    await running.stop()


@pytest.fixture(autouse=True)
def no_own_faults(request: pytest.FixtureRequest, caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    """Fail on faults of the console's own that it survives: they would go unseen here."""
    yield
    if request.node.get_closest_marker("own_faults") is None:
        records = caplog.get_records("call")
        faults = [record for record in records if record.name == fault_guard.__name__]
        assert not faults, [record.exc_text or record.getMessage() for record in faults]


@pytest.fixture
async def ros_2() -> AsyncIterator[RosbridgeServer]:
    """Two quiet simulated robots on two floors behind a bridge of ROS 2."""
    running = RosbridgeServer(OhFleet(robots=2, floors=2, seed=1, quiet=True), dialect=ROS2)
    await running.start()
    yield running
    await running.stop()


@pytest.fixture
async def nav2() -> AsyncIterator[RosbridgeServer]:
    """A quiet simulated robot with Nav2 behind a bridge that has been up for long."""
    running = RosbridgeServer(Nav2Fleet(1, 1, seed=1, quiet=True), dialect=ROS2)
    await running.start()
    running.bridge.started -= 10.0
    yield running
    await running.stop()


@pytest.fixture
def folder(server: RosbridgeServer, tmp_path: Path) -> Path:
    """A config for two robots on two floors, in which what is not answered or seen ends soon."""
    text = "[alarms]\nno_answer_after = 1.0\nnot_confirmed_after = 1.0\n"
    path = config_file(tmp_path, server.url, 2, 2)
    path.write_text(text + path.read_text())
    return tmp_path


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    """Two quiet robots with Nav2."""
    async with nav2_site(tmp_path, rate=10.0) as running:
        yield running
