"""Faults of robots that are driven by hand."""

import math
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.faults.plays import Faults, each_step, robot_of
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


def no_timeout(server: "RosbridgeServer", robot: str) -> None:
    """Let the robot follow its last twist for ever."""
    robot_of(server, robot).wheels.timeout = math.inf


def foreign_drive(server: "RosbridgeServer", robot: str) -> None:
    """Publish twists as another client would, once the robot is driven by hand."""
    from fleet_tui.simulator.frames import Payload

    wheels: Wheels = robot_of(server, robot).wheels
    topic, due = f"/{robot}/{TOPIC}", EVERY

    def step(passed: float) -> None:
        nonlocal due
        due -= passed
        if wheels.driven >= DRIVEN and due <= 0.0 and topic in server.bridge.topics:
            due = EVERY
            server.bridge.publish(topic, Payload(FOREIGN))
            wheels.take(FOREIGN)

    each_step(server, robot, step)


def lag(server: "RosbridgeServer", robot: str) -> None:
    """Let the bridge lag once the robot is driven by hand."""
    wheels: Wheels = robot_of(server, robot).wheels

    def step(_passed: float) -> None:
        if wheels.driven >= DRIVEN:
            server.bridge.services.lag = LAG

    each_step(server, robot, step)


FAULTS: Faults = {
    "no-timeout": (
        f"driven by hand it follows the last twist for ever, instead of {TIMEOUT:g} s",
        no_timeout,
    ),
    "foreign-drive": (f"another client drives, too, {DRIVEN:g} s after a hand", foreign_drive),
    "lag": (f"{DRIVEN:g} s after a hand all that the bridge sends is {LAG:g} s late", lag),
}
