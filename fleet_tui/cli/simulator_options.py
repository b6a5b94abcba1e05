"""Options of simulated fleets: kind, number of robots, faults with their list in the help."""

from collections.abc import Callable, Iterable, Mapping
from textwrap import fill
from typing import Any, TypeVar

import click

from fleet_tui.arriving import SimulatedFleet
from fleet_tui.cli.offers import listed, one_of
from fleet_tui.errors import did_you_mean
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.site import MIXED
from fleet_tui.simulator.vda5050.faults import FAULTS as VEHICLE_FAULTS

F = TypeVar("F", bound=Callable[..., Any])


def _fault_list(kind: str) -> str:
    """Return one entry for each fault; continued lines are indented."""
    entries = [f"{name:<16} {text}" for name, text in _texts(kind).items()]
    return "\n".join(fill(entry, 78, initial_indent="  ", subsequent_indent=" " * 19) for entry in entries)


def _texts(kind: str) -> Mapping[str, str]:
    """Return the faults of a kind, with what they do."""
    faults: Mapping[str, tuple[str, object]] = VEHICLE_FAULTS if kind == ON_BROKER else KINDS[kind].faults
    return {name: text for name, (text, _) in faults.items()}


ON_BROKER = "vda5050"
"""The kind of robots that is on a broker instead of behind a bridge."""
USUAL = next(iter(KINDS))
WORDS = (*KINDS, ON_BROKER, MIXED)
IN_MIXED = 2 * len(KINDS)
"""The usual number of robots in a mixed fleet."""
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
