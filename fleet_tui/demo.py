"""A simulated fleet in a process of its own, and the configuration that points at it."""

import importlib
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import msgspec

from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.adapters.profile import Profile
from fleet_tui.config.schema import Config, FloorEntry, Link, RobotEntry
from fleet_tui.errors import FleetError

# Seconds for the simulator to end by itself.
PATIENCE = 1.0


@contextmanager
def simulated(
    robots: int, floors: int, faults: str = "", speed: float = 1.0, ros: str = "1"
) -> Iterator[str]:
    """Start the simulator on a free port; its URL. It ends with us, even if we are killed."""
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0", "--stop-with-stdin"]
    command += ["--robots", str(robots), "--floors", str(floors), "--fault", faults]
    command += ["--speed", str(speed), "--ros", ros]
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


def demo_config(found: Config, url: str, robots: int, floors: int, ros: str = "1") -> Config:
    """Theme and keys of the config found; links, floors and robots of the simulator."""
    return msgspec.structs.replace(
        found,
        rosbridge=Link(url),
        links={},
        floors=[FloorEntry(f"floor_{n}") for n in range(floors)],
        robots=[RobotEntry(f"robot_{n}") for n in range(robots)],
        profile=_profile(ros),
    )


def _profile(ros: str) -> Profile:
    # The simulated robots tell whether they are paused.
    topics = {"paused": "/{robot}/paused"}
    if ros == "1":
        return Profile(topics=topics)
    from fleet_tui.simulator.ros.ros2 import ROS2

    return Profile(
        topics=topics,
        types={key: ROS2.message_type(type_) for key, (_, type_) in VOCABULARY.topics.items()},
        service_types={key: ROS2.service_type(type_) for key, (_, type_) in VOCABULARY.services.items()},
    )
