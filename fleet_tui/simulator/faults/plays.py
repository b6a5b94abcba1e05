"""How faults are applied: at once, at each step, again and again, once after a while."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.server import RosbridgeServer

Play = Callable[["RosbridgeServer", str], None]
"""Applies a fault to a robot."""
Faults = Mapping[str, tuple[str, Play]]
"""Faults by name: the help text, and the function that applies the fault."""

FLAT = 8.0  # per cent above which `battery` never charges


def robot_of(server: "RosbridgeServer", robot: str) -> Any:
    return server.bridge.services.fleet_of(robot).robots[robot]


def having(part: Callable[["RosbridgeServer", str], Any], **values: object) -> Play:
    """Return a fault that sets attributes of a part of the simulation."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        for name, value in values.items():
            setattr(part(server, robot), name, value)

    return play


def each_step(server: "RosbridgeServer", robot: str, act: Callable[[float], None]) -> None:
    """Call a function at each step with the seconds that passed for clients, in whose time faults are."""
    server.bridge.services.fleet_of(robot).troubles.append(lambda dt: act(dt / server.speed))


def every(server: "RosbridgeServer", robot: str, seconds: float, act: Callable[[], None]) -> None:
    """Call a function again and again."""
    age = 0.0

    def step(passed: float) -> None:
        nonlocal age
        age += passed
        if age > seconds:
            age = 0.0
            act()

    each_step(server, robot, step)


def obstacle(server: "RosbridgeServer", robot: str) -> None:
    """Put an obstacle before it that stays."""
    robot_of(server, robot).block()


def battery(server: "RosbridgeServer", robot: str) -> None:
    """Give it a battery that never charges fully."""
    body = robot_of(server, robot)

    def step(_passed: float) -> None:
        body.battery = min(body.battery, FLAT)

    each_step(server, robot, step)
