"""A simulated fleet in a process of its own, and the configuration that points at it."""

import importlib
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import msgspec

from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.registry import DEFAULT_KIND
from fleet_tui.config.schema import Config, FloorEntry, Link, RobotEntry
from fleet_tui.errors import FleetError

# Seconds for the simulator to end by itself.
PATIENCE = 1.0


@contextmanager
def simulated(
    robots: int, floors: int, faults: str = "", speed: float = 1.0, ros: str = "", kind: str = DEFAULT_KIND
) -> Iterator[str]:
    """Start the simulator on a free port; its URL. It ends with us, even if we are killed."""
    command = [sys.executable, "-m", "fleet_tui", "sim", "--port", "0", "--stop-with-stdin"]
    command += ["--robots", str(robots), "--floors", str(floors), "--fault", faults]
    command += ["--speed", str(speed), "--kind", kind, *(["--ros", ros] if ros else [])]
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


def demo_config(
    found: Config,
    url: str,
    robots: int,
    floors: int,
    ros: str = "1",
    kind: str = DEFAULT_KIND,
    folder: Path = Path(),
) -> Config:
    """Theme and keys of the config found; links, floors and robots of the simulator. The route graphs of a
    kind that publishes none are written to the folder."""
    names = [f"floor_{n}" for n in range(floors)]
    graphs = graphs_of(kind, folder, names)
    return msgspec.structs.replace(
        found,
        rosbridge=Link(url),
        links={},
        floors=[FloorEntry(name, graph=graphs.get(name, "")) for name in names],
        robots=[RobotEntry(f"robot_{n}") for n in range(robots)],
        profile=_of_nav2(floors) if kind == "nav2" else _of_source(ros),
        profiles={},
    )


def graphs_of(kind: str, folder: Path, floors: Sequence[str]) -> dict[str, str]:
    """Write the route graph of each floor, and return the files by floor; none for a kind that publishes
    them."""
    from fleet_tui.simulator.kinds import KINDS

    if not KINDS[kind].graph_files:
        return {}
    from fleet_tui.simulator.navigating.graph_file import write_graphs

    path = folder / "graph.geojson" if len(floors) == 1 else folder
    return dict(zip(floors, map(str, write_graphs(path, len(floors))), strict=True))


def _of_nav2(floors: int) -> Profile:
    # Of several floors the simulated robots say on which one they are, and each has a map.
    several = {"floor": "/{robot}/floor", "map": "/{floor}/map"} if floors > 1 else {}
    return Profile(kind="nav2", topics=several)


def _of_source(ros: str) -> Profile:
    # The simulated robots tell whether they are paused.
    topics = {"paused": "/{robot}/paused"}
    if ros != "2":
        return Profile(topics=topics)
    from fleet_tui.simulator.ros.ros2 import ROS2

    return Profile(
        topics=topics,
        types={key: ROS2.message_type(type_) for key, (_, type_) in VOCABULARY.topics.items()},
        service_types={key: ROS2.service_type(type_) for key, (_, type_) in VOCABULARY.services.items()},
    )
