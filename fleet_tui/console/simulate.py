"""Commands that simulate robots. The command line imports this module when one of them is used."""

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from textwrap import fill
from typing import Any, TypeVar

import click
from click.core import ParameterSource

from fleet_tui.cli.offers import listed, one_of
from fleet_tui.cli.options import NearestGroup, NumberRange, appearance, merged, screen, without_config
from fleet_tui.console.launch import SimulatedFleet, open_demo
from fleet_tui.simulator.faults import parse_faults_of
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.site import MIXED, faults_of, needs_graph_files, site_of
from fleet_tui.simulator.vda5050.faults import FAULTS as VEHICLE_FAULTS
from fleet_tui.text.errors import did_you_mean

F = TypeVar("F", bound=Callable[..., Any])

LAST_PORT = 65535
MQTT_PORT = 1883


ON_BROKER = "vda5050"
"""The kind of robots that is on a broker instead of behind a bridge."""
USUAL = next(iter(KINDS))
WORDS = (*KINDS, ON_BROKER, MIXED)
IN_MIXED = 2 * len(KINDS)
"""The usual number of robots in a mixed fleet."""
_floors: Callable[[F], F] = click.option(
    "--floors",
    type=click.IntRange(1, 20),
    metavar="N",
    default=SimulatedFleet().floors,
    show_default=True,
    help="Number of floors.",
)


def _fault_list(kind: str) -> str:
    """Return one entry for each fault; continued lines are indented."""
    entries = [f"{name:<16} {text}" for name, text in _texts(kind).items()]
    return "\n".join(fill(entry, 78, initial_indent="  ", subsequent_indent=" " * 19) for entry in entries)


def _texts(kind: str) -> Mapping[str, str]:
    """Return the faults of a kind, with what they do."""
    faults: Mapping[str, tuple[str, object]] = VEHICLE_FAULTS if kind == ON_BROKER else KINDS[kind].faults
    return {name: text for name, (text, _) in faults.items()}


FAULT_LIST = "\b\nFaults:\n" + _fault_list(USUAL)
ALL_FAULTS = FAULT_LIST + "".join(
    f"\n\n\b\nFaults of --kind {kind}:\n{_fault_list(kind)}" for kind in (*KINDS, ON_BROKER) if kind != USUAL
)


def _faults_of_kind(context: click.Context) -> Iterable[str]:
    """Return the names of faults of the kind that is typed, of all kinds for a mixed fleet."""
    kind = str(context.params.get("kind"))
    chosen = [kind] if kind in (*KINDS, ON_BROKER) else KINDS
    return dict.fromkeys(name for one in chosen for name in _texts(one))


def fault_option(command: F) -> F:
    return click.option(
        "--fault",
        default="",
        metavar="NAME[:ROBOT],...",
        shell_complete=listed(_faults_of_kind),
        help="Simulate these faults, of all robots or of one.",
    )(command)


def _known_kind(_context: click.Context, _option: click.Parameter, kind: str) -> str:
    if kind not in WORDS:
        near = did_you_mean(kind, WORDS) or f": {', '.join(WORDS)}"
        raise click.BadParameter(f"unknown kind of robot: {kind}{near}")
    return kind


def kind_option(command: F) -> F:
    return click.option(
        "--kind",
        "kind",
        default=USUAL,
        callback=_known_kind,
        is_eager=True,  # the usual number of robots depends on it
        metavar="|".join(WORDS),
        shell_complete=one_of(WORDS),
        show_default=True,
        help=f"Simulate robots of this kind; {MIXED}: those behind bridges in turn, on several, and two"
        f" of {ON_BROKER} on a broker.",
    )(command)


def robots_option(command: F) -> F:
    return click.option(
        "--robots",
        type=click.IntRange(1, 500),
        metavar="N",
        callback=_usual_robots,
        show_default=f"{SimulatedFleet().robots}, {MIXED}: {IN_MIXED}",
        help="Number of robots.",
    )(command)


def _usual_robots(context: click.Context, _option: click.Parameter, robots: int | None) -> int:
    """Return the number of robots: two of each kind in a mixed fleet, unless told otherwise."""
    return robots or (IN_MIXED if context.params["kind"] == MIXED else SimulatedFleet().robots)


def _simulation(command: F) -> F:
    """Add `--speed` and `--fault`."""
    speed = click.option(
        "--speed",
        type=NumberRange(0.1, 100.0),
        metavar="X",
        default=1.0,
        show_default=True,
        help="Run the simulated time this many times as fast; message rates stay the same.",
    )
    return speed(fault_option(command))


def _ros(command: F) -> F:
    return click.option(
        "--ros",
        "ros",
        type=click.Choice(["1", "2"]),
        default=None,
        show_default="depends on the kind",
        help="Simulate a bridge of this ROS version.",
    )(command)


def _announce(graph_file: Path | None, floors: int, urls: Sequence[str]) -> None:
    """Write the graphs and print the addresses: only now, as a port may have been unavailable."""
    from fleet_tui.simulator.graph_files import write_graphs

    if graph_file:
        write_graphs(graph_file, floors)
    for url in urls:
        click.echo(url)
    if sys.stdout.isatty():
        click.echo(f"open it in another terminal: fleet-tui {urls[0]}; Ctrl-C ends it", err=True)


@click.group(cls=NearestGroup)
def simulated() -> None:
    """Group of the commands, which the command line lists as its own."""


def _check(kind: str, robots: int, ros: str | None, port: int = 0) -> None:
    """Reject options that such robots don't support. Raises UsageError."""
    if kind == ON_BROKER:
        if ros:
            raise click.UsageError(f"kind {kind} has no ROS: leave out --ros")
    elif kind == MIXED:
        if robots < (least := len(KINDS)):
            raise click.UsageError(f"all {least} kinds need at least --robots {least}")
        if ros:
            raise click.UsageError("--ros needs a single kind: a mixed fleet runs on ROS 1 and 2")
        if port > (last := LAST_PORT + 1 - (ports := len(site_of(MIXED, robots)))):
            raise click.UsageError(f"a {MIXED} fleet needs {ports} ports: --port {last} is the maximum")
    elif ros and ros not in KINDS[kind].ros:
        raise click.UsageError(f"kind {kind} runs on ROS {' and '.join(KINDS[kind].ros)} only")


@simulated.command(epilog="`fleet-tui sim --help` lists the faults.")
@kind_option
@robots_option
@_floors
@_ros
@_simulation
@screen
@appearance
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
    _check(kind, robots, ros)
    if kind != ON_BROKER:
        parse_faults_of(fault, faults_of(site_of(kind, robots, ros or "")))
    fleet = SimulatedFleet(robots, floors, fault, speed, ros or "", kind)
    open_demo(fleet, config_file, read_only, drawing, debug)


@simulated.command(epilog=ALL_FAULTS)
@kind_option
@robots_option
@_floors
@click.option(
    "--port",
    type=click.IntRange(0, LAST_PORT),
    metavar="PORT",
    default=9090,
    show_default=True,
    help=f"Listen on this port; 0 picks a free one. A {MIXED} fleet also takes the next ports; a broker is on"
    f" {MQTT_PORT} by default.",
)
@click.option(
    "--rate",
    type=NumberRange(0.1, 100),
    metavar="HZ",
    default=10.0,
    show_default=True,
    help="Poses per second and robot.",
)
@click.option(
    "--seed", type=int, metavar="N", default=1, show_default=True, help="Seed of the random numbers."
)
@click.option("--stop-with-stdin", is_flag=True, hidden=True)
@click.option(
    "--first",
    type=click.IntRange(0, 9999),
    metavar="N",
    default=0,
    show_default=True,
    help="Number in the first robot's name.",
)
@click.option(
    "--graph-file",
    metavar="PATH",
    type=click.Path(path_type=Path),
    help="Write the route graph of robots that publish none: a GeoJSON file, or for several floors a folder"
    f" of them; for {ON_BROKER} a folder of LIF files.",
)
@_ros
@_simulation
@without_config
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
    """Serve a simulated fleet until Ctrl-C."""
    from fleet_tui.simulator.run import run

    _check(kind, robots, ros, port)
    if kind == ON_BROKER:
        _on_broker(
            robots,
            floors,
            port,
            rate,
            seed,
            stop_with_stdin=stop_with_stdin,
            first=first,
            graph_file=graph_file,
            fault=fault,
            speed=speed,
        )
        return
    if graph_file and not needs_graph_files(kind):
        raise click.UsageError(f"--graph-file: robots of kind {kind} publish their graph")
    run(
        robots,
        floors,
        port,
        rate,
        seed,
        partial(_announce, graph_file, floors),
        stop_with_stdin=stop_with_stdin,
        faults=fault,
        first=first,
        speed=speed,
        ros=ros or "",
        kind=kind,
        beside=_beside(floors, seed, rate, speed) if kind == MIXED else None,
    )


def _beside(*options: Any) -> Any:
    """Return the vehicles of a mixed fleet, None with a note where no broker is installed."""
    from fleet_tui.simulator.vda5050 import broker, serving

    if not broker.has_broker():
        click.echo(broker.NO_BROKER, err=True)
    return serving.vehicles_beside(*options)


def _on_broker(
    robots: int,
    floors: int,
    port: int,
    rate: float,
    seed: int,
    *,
    stop_with_stdin: bool,
    first: int,
    graph_file: Path | None,
    fault: str,
    speed: float,
) -> None:
    """Serve simulated vehicles on a broker of their own."""
    from fleet_tui.simulator.graph_files import write_lif
    from fleet_tui.simulator.vda5050.serving import serve, vehicles_of

    given = click.get_current_context().get_parameter_source("port")
    if given is ParameterSource.DEFAULT:
        port = MQTT_PORT
    vehicles = vehicles_of([f"robot_{n}" for n in range(first, first + robots)], floors, seed, fault)
    if graph_file:
        write_lif(graph_file, floors)
    serve(vehicles, port, rate, partial(_announce, None, floors), stop_with_stdin, speed)
