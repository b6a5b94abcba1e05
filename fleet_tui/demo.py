"""A simulated fleet in a process of its own, and the configuration that points at it."""

import importlib
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import msgspec

from fleet_tui.config.profile import Profile
from fleet_tui.config.schema import Config, FloorEntry, Link, RobotEntry
from fleet_tui.errors import FleetError

# Seconds for the simulator to end by itself.
PATIENCE = 1.0


@contextmanager
def simulated(robots: int, floors: int, faults: str = "") -> Iterator[str]:
    """Start the simulator on a free port; its URL. It ends with us, even if we are killed."""
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0", "--stop-with-stdin"]
    command += ["--robots", str(robots), "--floors", str(floors), "--fault", faults]
    with subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    ) as child:
        # While it starts, import what takes long.
        importlib.import_module("fleet_tui.app")

        assert child.stdout is not None
        try:
            url = child.stdout.readline().decode().strip()
            if not url.startswith("ws://"):
                raise FleetError("the simulator did not start: try `fleet-tui sim` to see why")
            yield url
        finally:
            child.terminate()
            try:
                child.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                child.kill()


def demo_config(found: Config, url: str, robots: int, floors: int) -> Config:
    """Theme and keys of the config found; links, floors and robots of the simulator."""
    return msgspec.structs.replace(
        found,
        rosbridge=Link(url),
        links={},
        floors=[FloorEntry(f"floor_{n}") for n in range(floors)],
        robots=[RobotEntry(f"robot_{n}") for n in range(robots)],
        # The simulated robots tell whether they are paused.
        profile=Profile(topics={"paused": "/{robot}/paused"}),
    )
