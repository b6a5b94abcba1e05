"""Faults of robots that are driven by hand."""

import math
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.faults.wire import Play
from fleet_tui.simulator.senses.wheels import TIMEOUT, TOPIC, Wheels

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.server import RosbridgeServer

DRIVEN = 1.0  # seconds by hand after which another client drives as well
EVERY = 0.2  # seconds between its twists
LAG = 0.5  # seconds
FOREIGN: dict[str, Any] = {
    "linear": {"x": 0.07, "y": 0.0, "z": 0.0},
    "angular": {"x": 0.0, "y": 0.0, "z": 0.9},
}


def _wheels(server: "RosbridgeServer", robot: str) -> Wheels:
    return server.bridge.services.fleet_of(robot).robots[robot].wheels


def no_timeout(server: "RosbridgeServer", robot: str) -> None:
    """Let the robot follow its last twist for ever."""
    _wheels(server, robot).timeout = math.inf


def foreign_drive(server: "RosbridgeServer", robot: str) -> None:
    """Publish twists as another client would, once the robot is driven by hand."""
    from fleet_tui.simulator.frames import Payload

    wheels, topic, due = _wheels(server, robot), f"/{robot}/{TOPIC}", EVERY

    def step(dt: float) -> None:
        nonlocal due
        due -= dt / server.speed
        if wheels.driven >= DRIVEN and due <= 0.0 and topic in server.bridge.topics:
            due = EVERY
            server.bridge.publish(topic, Payload(FOREIGN))
            wheels.take(FOREIGN)

    server.bridge.services.fleet_of(robot).troubles.append(step)


def lag(server: "RosbridgeServer", robot: str) -> None:
    """Let the bridge lag once the robot is driven by hand."""
    wheels, services = _wheels(server, robot), server.bridge.services

    def step(_dt: float) -> None:
        if wheels.driven >= DRIVEN:
            services.lag = LAG

    services.fleet_of(robot).troubles.append(step)


FAULTS: dict[str, tuple[str, Play]] = {
    "no-timeout": (
        f"driven by hand it follows the last twist for ever, instead of {TIMEOUT:g} s",
        no_timeout,
    ),
    "foreign-drive": (f"another client drives, too, {DRIVEN:g} s after a hand", foreign_drive),
    "lag": (f"{DRIVEN:g} s after a hand all that the bridge sends is {LAG:g} s late", lag),
}
"""The same for robots of every kind."""
