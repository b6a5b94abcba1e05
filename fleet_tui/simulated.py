"""The commands that simulate robots. The command line imports this module when one of them is asked for."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

import click

from fleet_tui.config.load import load_if_any
from fleet_tui.errors import did_you_mean
from fleet_tui.options import common, merged, screen
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import KINDS

F = TypeVar("F", bound=Callable[..., Any])


def _fault_list(kind: str) -> str:
    return "\n".join(f"  {name:<15}{text}" for name, (text, _) in KINDS[kind].faults.items())


USUAL = "oh_ressources"
FAULT_LIST = "\b\nFaults:\n" + _fault_list(USUAL)
ALL_FAULTS = FAULT_LIST + "".join(
    f"\n\n\b\nFaults of --kind {kind}:\n{_fault_list(kind)}" for kind in KINDS if kind != USUAL
)


def _faults(command: F) -> F:
    """What the simulator is to do wrong."""
    return click.option(
        "--fault",
        default="",
        metavar="NAME[:ROBOT],...",
        help="What goes wrong, for every robot or for one; see below.",
    )(command)


def _simulation(command: F) -> F:
    """How the simulator behaves, faults aside."""
    speed = click.option(
        "--speed",
        type=click.FloatRange(0.1, 100.0),
        default=1.0,
        show_default=True,
        help="Seconds of the robots' time in a second; the rates on the wire stay.",
    )
    return speed(_faults(command))


def _ros(command: F) -> F:
    """The generation of ROS; without it the one that is usual for the robots."""
    return click.option(
        *("--ros", "ros"),
        type=click.Choice(["1", "2"]),
        default=None,
        show_default="1; 2 for nav2",
        help="Generation of ROS.",
    )(command)


def _known_kind(_context: click.Context, _option: click.Parameter, kind: str) -> str:
    if kind not in KINDS:
        near = did_you_mean(kind, KINDS) or f": {', '.join(KINDS)}"
        raise click.BadParameter(f"no such kind of robots: {kind}{near}")
    return kind


def _announce(graph_file: Path | None, floors: int, url: str) -> None:
    """Say that the server is there. Before that, its port may not be had, and no file is written."""
    from fleet_tui.simulator.navigating.graph_file import write_graphs

    if graph_file:
        write_graphs(graph_file, floors)
    click.echo(url)


@click.group()
def simulated() -> None:
    """Holds the commands; the command line shows them as its own."""


def _kind(command: F) -> F:
    """The kind of the simulated robots."""
    return click.option(
        *("--kind", "kind"),
        default=USUAL,
        callback=_known_kind,
        metavar="|".join(KINDS),
        show_default=True,
        help="What the robots are.",
    )(command)


def _check_ros(kind: str, ros: str | None) -> None:
    if ros and ros not in KINDS[kind].ros:
        raise click.UsageError(f"robots of kind {kind} run on ROS {' and '.join(KINDS[kind].ros)} only")


@simulated.command(epilog=ALL_FAULTS)
@_kind
@click.option("--robots", type=click.IntRange(1, 500), default=3, show_default=True)
@click.option("--floors", type=click.IntRange(1, 20), default=2, show_default=True)
@_ros
@_simulation
@screen
@common
@merged
def demo(
    config_file: str | None,
    debug: bool,
    kind: str,
    robots: int,
    floors: int,
    fault: str,
    speed: float,
    ros: str | None,
    read_only: bool,
    drawing: str | None,
) -> None:
    """Open the console on a simulated fleet. No ROS, no network."""
    from fleet_tui.demo import simulated as running

    _check_ros(kind, ros)
    parse_faults(fault, [f"robot_{n}" for n in range(robots)], KINDS[kind].faults)
    with (
        TemporaryDirectory(prefix="fleet-tui-") as folder,
        running(robots, floors, fault, speed, ros or "", kind) as url,
    ):
        from fleet_tui.console import open_console
        from fleet_tui.demo import demo_config

        found = load_if_any(config_file)
        config = demo_config(found, url, robots, floors, ros or "", kind, Path(folder))
        open_console(config, read_only, drawing, debug, demo=True)


@simulated.command(epilog=ALL_FAULTS)
@_kind
@click.option("--robots", type=click.IntRange(1, 500), default=3, show_default=True)
@click.option("--floors", type=click.IntRange(1, 20), default=2, show_default=True)
@click.option(
    "--port", type=click.IntRange(0, 65535), default=9090, show_default=True, help="0 takes a free one."
)
@click.option(
    "--rate", type=click.FloatRange(0.1, 100), default=10.0, show_default=True, help="Poses per second."
)
@click.option("--seed", type=int, default=1, show_default=True)
@click.option("--stop-with-stdin", is_flag=True, hidden=True)
@click.option(
    "--first", type=click.IntRange(0, 9999), default=0, show_default=True, help="Number of the first robot."
)
@click.option(
    "--graph-file",
    metavar="PATH",
    type=click.Path(path_type=Path),
    help="Write the route graph for nav2 here: a GeoJSON file, with several floors a folder of them.",
)
@_ros
@_simulation
@common
@merged
def sim(
    config_file: str | None,
    debug: bool,
    kind: str,
    robots: int,
    floors: int,
    port: int,
    rate: float,
    seed: int,
    stop_with_stdin: bool,
    first: int,
    graph_file: Path | None,
    fault: str,
    speed: float,
    ros: str | None,
) -> None:
    """Serve a simulated fleet to several consoles, until Ctrl-C."""
    from fleet_tui.simulator.run import run

    _check_ros(kind, ros)
    if graph_file and not KINDS[kind].graph_files:
        raise click.UsageError(f"robots of kind {kind} publish their graph: --graph-file is for others")
    announce = partial(_announce, graph_file, floors)
    run(robots, floors, port, rate, seed, announce, stop_with_stdin, fault, first, speed, ros or "", kind)
