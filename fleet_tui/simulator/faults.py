"""What the simulator can do wrong on request: `--fault NAME[:ROBOT]`, several with commas between.

A fault of the wire changes how services answer; one of the world happens to the robot itself.
"""

import json
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import TYPE_CHECKING

from msgspec import structs

from fleet_tui.errors import ConfigError, did_you_mean

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.frames import Frame
    from fleet_tui.simulator.server import RosbridgeServer
    from fleet_tui.simulator.session import Session

Play = Callable[["RosbridgeServer", str], None]

LATE = 8.0  # seconds after which `late` answers
LIVES = 2.0  # seconds after its first order at which `restart` starts anew
FLAT = 8.0  # per cent above which `battery` never charges
JUMP = 3.0  # metres by which `jumping` is beside itself every other second


def _services(server: "RosbridgeServer", robot: str, verb: str = "") -> list[str]:
    return [name for name in server.services if name.startswith(f"/{robot}/Application_layout/{verb}")]


def _refuse(server: "RosbridgeServer", robot: str) -> None:
    for service in _services(server, robot, "Execute_order"):
        server.answers[service] = lambda args: {
            "request_id": args.get("request_id", 0),
            "status": "REJECTED: the simulator was asked to refuse",
        }


def _never(server: "RosbridgeServer", robot: str) -> None:
    server.silent_services.update(_services(server, robot))


def _delivered(deliver: Callable[["RosbridgeServer", "Session", "Frame"], None]) -> Play:
    """A fault of the way on which answers are brought back; the service itself does what it should."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        for service in _services(server, robot):
            server.deliveries[service] = lambda session, frame: deliver(server, session, frame)

    return play


def _late(_server: "RosbridgeServer", session: "Session", frame: "Frame") -> None:
    session.reply_in(LATE, frame)


def _twice(_server: "RosbridgeServer", session: "Session", frame: "Frame") -> None:
    session.reply(frame)
    session.reply(frame)


def _wrong_id(_server: "RosbridgeServer", session: "Session", frame: "Frame") -> None:
    answer = json.loads(frame)
    session.reply(json.dumps(answer | {"id": f"not-{answer.get('id')}"}))


def _drop(server: "RosbridgeServer", _session: "Session", _frame: "Frame") -> None:
    server.abort_clients()


def _restart(server: "RosbridgeServer", robot_name: str) -> None:
    robot, age = server.world.robots[robot_name], 0.0

    def step(dt: float) -> None:
        nonlocal age
        age = age + dt if robot.last_order_id else 0.0
        if age > LIVES:
            robot.drop({order.id for order in robot.orders})
            robot.last_order_id = robot.request_id = 0

    server.world.troubles.append(step)


def _obstacle(server: "RosbridgeServer", robot: str) -> None:
    server.world.robots[robot].block()


def _stuck(server: "RosbridgeServer", robot: str) -> None:
    server.world.robots[robot].stuck = True


def _silent(server: "RosbridgeServer", robot: str) -> None:
    server.world.robots[robot].silence = float("inf")


def _paused(server: "RosbridgeServer", robot: str) -> None:
    server.world.robots[robot].paused = True


def _battery(server: "RosbridgeServer", robot_name: str) -> None:
    robot = server.world.robots[robot_name]

    def step(_dt: float) -> None:
        robot.battery = min(robot.battery, FLAT)

    server.world.troubles.append(step)


def _jumping(server: "RosbridgeServer", robot_name: str) -> None:
    """A robot that does not know where it is does not drive."""
    world, robot, beside = server.world, server.world.robots[robot_name], 0.0
    robot.stuck = True

    def step(_dt: float) -> None:
        nonlocal beside
        wanted = JUMP * (int(world.time) % 2)
        robot.pose = structs.replace(robot.pose, x=robot.pose.x + wanted - beside)
        beside = wanted

    world.troubles.append(step)


def _stale(server: "RosbridgeServer", robot: str) -> None:
    server.muted.add(f"/{robot}/pose")


FAULTS: Mapping[str, tuple[str, Play]] = {
    "refuse": ("every order is refused", _refuse),
    "late": (f"answers come after {LATE:g} s", _delivered(_late)),
    "twice": ("every answer comes twice", _delivered(_twice)),
    "never": ("commands are neither answered nor carried out", _never),
    "wrong-id": ("answers come with wrong call ids", _delivered(_wrong_id)),
    "drop": ("a command is carried out, and all connections break before the answer", _delivered(_drop)),
    "restart": (f"{LIVES:g} s after its first order it starts anew: no orders, ids from 0", _restart),
    "obstacle": ("an obstacle that stays", _obstacle),
    "stuck": ("it has orders and does not move", _stuck),
    "silent": ("nothing is heard of it", _silent),
    "paused": ("it is paused from the start", _paused),
    "battery": (f"a battery that never holds more than {FLAT:g} %", _battery),
    "jumping": (f"its pose jumps by {JUMP:g} m, and it does not drive", _jumping),
    "stale": ("its pose stays away, everything else comes", _stale),
}
"""Each fault by its name: what it does, and how it is played on one robot."""


def parse_faults(text: str, robots: Collection[str]) -> list[tuple[str, str]]:
    """Fault and robot for each `NAME` (every robot) or `NAME:ROBOT` between the commas.

    Raises ConfigError with every name that is none.
    """
    wanted, problems = list[tuple[str, str]](), list[str]()
    for part in filter(None, (part.strip() for part in text.split(","))):
        name, _, robot = part.partition(":")
        if name not in FAULTS:
            near = did_you_mean(name, FAULTS)
            problems.append(f"--fault {part}: no such fault{near or ': ' + ', '.join(FAULTS)}")
        elif robot and robot not in robots:
            problems.append(f"--fault {part}: no such robot{did_you_mean(robot, robots)}")
        else:
            wanted += [(name, one) for one in ([robot] if robot else robots)]
    if problems:
        raise ConfigError(problems)
    return wanted


def play(server: "RosbridgeServer", wanted: Iterable[tuple[str, str]]) -> None:
    """Let these faults happen to these robots from now on."""
    for name, robot in wanted:
        FAULTS[name][1](server, robot)
