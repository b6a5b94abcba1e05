"""The simulator's faults on request: `--fault NAME[:ROBOT]`, several with commas between."""

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from fleet_tui.errors import ConfigError, did_you_mean
from fleet_tui.simulator.faults import wire, world

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.server import RosbridgeServer

Faults = Mapping[str, tuple[str, wire.Play]]
"""Faults by name: the text of the help, and how each is played on one robot."""

FAULTS: Faults = {
    "refuse": ("every order is refused", wire.refuse),
    "late": (f"answers come after {wire.LATE:g} s", wire.late),
    "slow-answer": (
        f"answers come after {wire.SLOW:g} s: on ROS 2 the bridge gives up before",
        wire.slow_answer,
    ),
    "late-call": (f"a frozen node takes orders after {wire.LATE:g} s and answers then", wire.late_call),
    "obeys-late": (f"commands are answered at once and obeyed after {wire.OBEYS:g} s", wire.obeys_late),
    "twice": ("every answer comes twice", wire.twice),
    "never": ("commands are neither answered nor carried out", wire.never),
    "wrong-id": ("answers come with wrong call ids", wire.wrong_id),
    "drop": ("a command is carried out, and all connections break before the answer", wire.drop),
    "dies": ("the node takes an order and dies before it answers", wire.dies),
    "throws": ("orders end in an exception of the node and are not taken", wire.throws),
    "unregistered": (f"after {wire.GONE:g} s its services do not exist, telemetry flows", wire.unregistered),
    "frozen-rosapi": ("rosapi never answers, everything else does", wire.frozen_rosapi),
    "overloaded": (
        f"the bridge carries {wire.CARRIED:g} messages a second, the others wait",
        wire.overloaded,
    ),
    "dead-rosapi": ("rosapi is not there, everything else is", wire.dead_rosapi),
    "volatile-maps": (
        f"maps, graphs and labels are not latched but come every {wire.AGAIN:g} s",
        wire.volatile_maps,
    ),
    "unsourced": ("the bridge lacks the package of the robots' messages", wire.unsourced),
    "stale": ("its pose stays away, everything else comes", wire.stale),
    "restart": (
        f"{world.LIVES:g} s after its first order it starts anew: no orders, ids from 0, no pause",
        world.restart,
    ),
    "foreign-cancel": (
        f"another console cancels every order after {world.FOREIGN:g} s",
        world.foreign_cancel,
    ),
    "foreign-pause": (
        f"another console pauses it {world.FOREIGN:g} s after its first order, for {world.FOREIGN_PAUSE:g} s",
        world.foreign_pause,
    ),
    "obstacle": ("an obstacle that stays", world.obstacle),
    "stuck": ("it has orders and does not move", world.stuck),
    "silent": ("nothing is heard of it", world.silent),
    "paused": ("it is paused from the start", world.paused),
    "battery": (f"a battery that never holds more than {world.FLAT:g} %", world.battery),
    "jumping": (f"its pose jumps by {world.JUMP:g} m, and it does not drive", world.jumping),
}
"""The faults of robots of the source's stack."""


def parse_faults(text: str, robots: Iterable[str], faults: Faults = FAULTS) -> list[tuple[str, str]]:
    """Fault and robot as `parse_faults_of` reads them, where all robots are of the kind with these faults.
    Raises ConfigError."""
    return parse_faults_of(text, dict.fromkeys(robots, faults))


def parse_faults_of(text: str, known: Mapping[str, Faults]) -> list[tuple[str, str]]:
    """Fault and robot for each `NAME` (every robot that knows it) or `NAME:ROBOT` between the commas.

    `known`: the faults that each robot knows. Raises ConfigError with every name that is none.
    """
    every = {name: fault for faults in known.values() for name, fault in faults.items()}
    wanted, problems = list[tuple[str, str]](), list[str]()
    for part in filter(None, (part.strip() for part in text.split(","))):
        name, _, robot = part.partition(":")
        faults = known.get(robot, every) if name in every else every
        if name not in faults:
            near = did_you_mean(name, faults)
            of_kind = " of this kind of robots" if name in FAULTS or name in every else ""
            problems.append(f"--fault {part}: no such fault{of_kind}{near or ': ' + ', '.join(faults)}")
        elif robot and robot not in known:
            problems.append(f"--fault {part}: no such robot{did_you_mean(robot, known)}")
        else:
            wanted += [(name, one) for one in ([robot] if robot else known) if name in known[one]]
    if problems:
        raise ConfigError(problems)
    return wanted


def play(server: "RosbridgeServer", wanted: Iterable[tuple[str, str]]) -> None:
    """Let these faults happen to these robots from now on."""
    for name, robot in wanted:
        server.fleet_of(robot).faults[name][1](server, robot)
