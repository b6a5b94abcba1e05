"""A simulated fleet in a process of its own, and its configuration."""

import importlib
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import msgspec

from fleet_tui.config.entries import DEFAULT_LINK, FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link, Notify, RoutinesConfig
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import DEFAULT_KIND
from fleet_tui.robots.registry import KINDS as ADAPTERS
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.site import MIXED, SitedBridge, needs_graph_files, site_of
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

# Maximum seconds for the simulator to end by itself.
PATIENCE = 1.0
ON_BROKER = "vda5050"
"""The kind of robots that is on a broker instead of behind a bridge."""
SIZE = (0.9, 0.6)
"""Length and width of a simulated robot, in metres."""


@contextmanager
def simulated(
    robots: int, floors: int, faults: str = "", speed: float = 1.0, ros: str = "", kind: str = DEFAULT_KIND
) -> Iterator[list[str]]:
    """Start the simulator on free ports; return the URLs of its bridges. It ends with us, even if we are
    killed."""
    command = [sys.executable, "-P", "-m", "fleet_tui", "sim", "--port", "0", "--stop-with-stdin"]
    command += ["--robots", str(robots), "--floors", str(floors), "--fault", faults]
    command += ["--speed", str(speed), "--kind", kind, *(["--ros", ros] if ros else [])]
    pipe, nothing = subprocess.PIPE, subprocess.DEVNULL
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=nothing, start_new_session=True) as child:
        # While it starts, import slow modules.
        importlib.import_module("fleet_tui.console.app")
        assert child.stdout is not None
        try:
            urls = [child.stdout.readline().decode().strip() for _ in range(_servers(kind, robots))]
            if not all(url.startswith(("ws://", "mqtt://")) for url in urls):
                raise FleetError(Message("the simulator did not start: run `fleet-tui sim` for the reason"))
            yield urls
        finally:
            child.terminate()
            try:
                child.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                child.kill()


def _servers(kind: str, robots: int) -> int:
    """Return the number of servers of the simulator."""
    from fleet_tui.simulator.vda5050.broker import has_broker

    if kind == ON_BROKER:
        return 1
    return len(site_of(kind, robots)) + (kind == MIXED and has_broker())


def demo_config(
    found: Config,
    url: str,
    robots: int,
    floors: int,
    ros: str = "",
    kind: str = DEFAULT_KIND,
    folder: Path = Path(),
    further: Sequence[str] = (),
) -> Config:
    """Return theme and keys of the user's config; links, floors and robots of the simulator. The route graphs
    of kinds that publish none are written to the folder. `further`: the URLs of all bridges but the first."""
    site = site_of(kind, robots, ros)
    links = dict(zip([DEFAULT_LINK, *(bridge.name for bridge in site[1:])], site, strict=True))
    names = [f"floor_{n}" for n in range(floors)]
    graphs = graphs_of(kind, folder, names)
    profiles = {one.kind: _profile(one.kind, floors, bridge.ros) for bridge in site for one in bridge.crews}
    alone = len(profiles) == 1
    return msgspec.structs.replace(
        found,
        rosbridge=Link(url),
        links={name: Link(other) for name, other in zip([*links][1:], further, strict=True)},
        floors=[FloorEntry(name, graph=graphs.get(name, "")) for name in names],
        robots=_robots(links, alone),
        profile=profiles[kind] if alone else Profile(),
        profiles={} if alone else profiles,
        programs=[],  # a demo stops nothing real, and starts nothing
        notify=Notify(),
        routines=RoutinesConfig(str(folder / "routines")),
    )


def vehicles_config(found: Config, url: str, robots: int, floors: int, folder: Path) -> Config:
    """Return theme and keys of the user's config, with simulated vehicles on a broker, whose master control
    is this console."""
    from fleet_tui.simulator.graph_files import write_lif

    graphs = write_lif(folder, floors)
    return msgspec.structs.replace(
        found,
        rosbridge=Link(),
        links={"broker": Link(url, role="master")},
        floors=[FloorEntry(f"floor_{n}", graph=str(file)) for n, file in enumerate(graphs)],
        robots=[RobotEntry(f"robot_{n}", link="broker", size=SIZE) for n in range(robots)],
        profile=Profile(kind=ON_BROKER),
        profiles={},
        programs=[],
        notify=Notify(),
        routines=RoutinesConfig(str(folder / "routines")),
    )


def with_vehicles(config: Config, url: str) -> Config:
    """Return the configuration of a mixed fleet with its vehicles on a broker, whose master control is this
    console. They drive on the graphs that the other robots have from files."""
    from fleet_tui.simulator.vda5050.serving import IN_MIXED

    vehicles = [RobotEntry(name, link="broker", size=SIZE) for name in IN_MIXED]
    links = {**config.links, "broker": Link(url, role="master")}
    return msgspec.structs.replace(config, links=links, robots=[*config.robots, *vehicles])


def _robots(links: Mapping[str, SitedBridge], alone: bool) -> list[RobotEntry]:
    """Return the robots behind all links; `alone`: all are of one kind."""
    entries = {
        number: RobotEntry(name, link=link, profile="" if alone else crew.kind, size=SIZE)
        for link, bridge in links.items()
        for crew in bridge.crews
        for number, name in zip(crew.numbers, crew.names, strict=True)
    }
    return [entries[number] for number in sorted(entries)]


def graphs_of(kind: str, folder: Path, floors: Sequence[str]) -> dict[str, str]:
    """Write the route graph of each floor, and return the files by floor; empty if every robot publishes
    it."""
    if not needs_graph_files(kind):
        return {}
    from fleet_tui.simulator.graph_files import write_graphs

    path = folder / "graph.geojson" if len(floors) == 1 else folder
    return dict(zip(floors, map(str, write_graphs(path, len(floors))), strict=True))


def _profile(kind: str, floors: int, ros: str) -> Profile:
    """Return the profile of the simulated robots of a kind, which run on their usual ROS."""
    from fleet_tui.simulator.run import DIALECTS

    profile = msgspec.convert({"kind": kind, **KINDS[kind].profile(floors)}, Profile)
    if ros == KINDS[kind].ros[0]:
        return profile
    usual, dialect = ADAPTERS[kind].vocabulary, DIALECTS[ros]
    return msgspec.structs.replace(
        profile,
        types={key: dialect.message_type(type_) for key, (_, type_) in usual.topics.items()},
        service_types={key: dialect.service_type(type_) for key, (_, type_) in usual.services.items()},
    )
