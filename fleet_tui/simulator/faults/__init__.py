"""The simulator's faults on request: `--fault NAME[:ROBOT]`, several with commas between."""

from collections.abc import Iterable, Mapping

from fleet_tui.simulator.faults import camera, hand, wire, world
from fleet_tui.simulator.faults.plays import FLAT, Faults, battery, having, obstacle, robot_of
from fleet_tui.text.errors import ConfigError, did_you_mean

FAULTS: Faults = {
    "refuse": ("all orders are refused", wire.refuse),
    "late": (f"replies after {wire.LATE:g} s", wire.late),
    "slow-answer": (f"replies after {wire.SLOW:g} s: on ROS 2 the bridge times out first", wire.slow_answer),
    "late-call": (f"a frozen node takes orders after {wire.LATE:g} s, then replies", wire.late_call),
    "obeys-late": (f"commands are answered at once and carried out after {wire.OBEYS:g} s", wire.obeys_late),
    "twice": ("every reply is sent twice", wire.twice),
    "never": ("commands are neither answered nor carried out", wire.never),
    "wrong-id": ("replies with wrong call ids", wire.wrong_id),
    "drop": ("commands are carried out, all connections drop before the reply", wire.drop),
    "dies": ("the node takes an order and dies before replying", wire.dies),
    "throws": ("orders raise an exception in the node and are not taken", wire.throws),
    "unregistered": (f"after {wire.GONE:g} s its services do not exist, telemetry flows", wire.unregistered),
    "topics-glob": ("the bridge's allow-list lacks its topics (topics_glob)", wire.topics_glob),
    "actions-glob": ("the bridge's allow-list lacks its actions (actions_glob)", wire.actions_glob),
    "services-glob": ("the bridge's allow-list lacks its services (services_glob)", wire.services_glob),
    "lost-master": (
        "the ROS master was restarted without rosapi: its services do not exist, telemetry flows",
        wire.lost_master,
    ),
    "frozen-rosapi": ("rosapi never replies, everything else does", wire.frozen_rosapi),
    "overloaded": (f"the bridge carries {wire.CARRIED:g} messages/s, the rest queues up", wire.overloaded),
    "dead-rosapi": ("no rosapi", wire.dead_rosapi),
    "half-dead": ("the bridge's ROS thread has ended: no topic, no node answers", wire.half_dead),
    "volatile-maps": (
        f"maps, graphs and labels not latched, sent every {wire.AGAIN:g} s",
        wire.volatile_maps,
    ),
    "unsourced": ("the bridge lacks the package of the robots' messages", wire.unsourced("OH_ressources")),
    "stale": ("no pose, everything else is sent", wire.without("pose")),
    "restart": (
        f"{world.LIVES:g} s after its first order it restarts: no orders, ids from 0, no pause",
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
    "obstacle": ("permanent obstacle", obstacle),
    "stuck": ("has orders but does not move", having(robot_of, stuck=True)),
    "silent": ("sends nothing", having(robot_of, silence=float("inf"))),
    "paused": ("paused from the start", having(robot_of, paused=True)),
    "battery": (f"battery never above {FLAT:g} %", battery),
    "mislocalised": ("believes to be 4 m away and turned, until its pose is set", world.mislocalised),
    **hand.FAULTS,
    "jumping": (f"pose jumps by {world.JUMP:g} m, does not drive", world.jumping),
    **camera.FAULTS,
}
"""The faults of robots of the source's stack."""


def parse_faults(text: str, robots: Iterable[str], faults: Faults = FAULTS) -> list[tuple[str, str]]:
    """Fault and robot as `parse_faults_of` reads them, where all robots are of the kind with these faults.
    Raises ConfigError."""
    return parse_faults_of(text, dict.fromkeys(robots, faults))


def parse_faults_of(text: str, known: Mapping[str, Faults]) -> list[tuple[str, str]]:
    """Return fault and robot for each `NAME` (every robot whose kind has it) or `NAME:ROBOT` between the
    commas. `known`: the faults by robot. Raises ConfigError with every unknown name."""
    every = {name: fault for faults in known.values() for name, fault in faults.items()}
    wanted, problems = list[tuple[str, str]](), list[str]()
    for part in filter(None, (part.strip() for part in text.split(","))):
        name, _, robot = part.partition(":")
        faults = known.get(robot, every) if name in every else every
        if name not in faults:
            near = did_you_mean(name, faults) if name != "list" else ""  # who asks for them gets them
            of_kind = " of this kind of robots" if name in FAULTS or name in every else ""
            problems.append(f"--fault {part}: unknown fault{of_kind}{near or ': ' + ', '.join(faults)}")
        elif robot and robot not in known:
            problems.append(f"--fault {part}: unknown robot{did_you_mean(robot, known)}")
        else:
            wanted += [(name, one) for one in ([robot] if robot else known) if name in known[one]]
    if problems:
        raise ConfigError(problems)
    return wanted
