"""Faults of fleets, of their robots, and of the dispatcher."""

import math
from typing import TYPE_CHECKING

from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.faults.plays import FLAT, Faults, every, having, robot_of

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.rmf.dispatcher import SimDispatcher
    from fleet_tui.simulator.rmf.fleet import RmfFleet
    from fleet_tui.simulator.rmf.lifts import SimDoor, SimLift
    from fleet_tui.simulator.robot import SimRobot
    from fleet_tui.simulator.server import RosbridgeServer

AGAIN = 20.0
"""Seconds after which a dispatcher restarts."""
FIRE = 3
CLOSED = (2, 5)
ISSUE = {"category": "lift", "detail": "lift_1 does not answer"}
PACKAGES = ("rmf_fleet_msgs", "rmf_task_msgs", "rmf_building_map_msgs", "rmf_lift_msgs", "rmf_door_msgs")


def fleet_at(server: "RosbridgeServer", robot: str) -> "RmfFleet":
    from fleet_tui.simulator.rmf.fleet import RmfFleet

    fleet = server.bridge.services.fleet_of(robot)
    assert isinstance(fleet, RmfFleet)
    return fleet


def _body(server: "RosbridgeServer", robot: str) -> "SimRobot":
    return fleet_at(server, robot).robots[robot].body


def _dispatcher(server: "RosbridgeServer", robot: str) -> "SimDispatcher":
    return fleet_at(server, robot).dispatcher


def _stuck(server: "RosbridgeServer", robot: str) -> None:
    _body(server, robot).block()


def restart_dispatcher(server: "RosbridgeServer", robot: str) -> None:
    """Start the dispatcher again: it takes every request once more that a client had latched."""
    from fleet_tui.simulator.rmf.fleet import REQUESTS

    fleet, topic = fleet_at(server, robot), server.bridge.topics.get(REQUESTS)
    fleet.dispatcher.restart()
    if topic is not None and topic.latched and topic.history is not None:
        for payload in topic.history():
            fleet.take(payload.msg)


def _restarts(server: "RosbridgeServer", robot: str) -> None:
    every(server, robot, AGAIN, lambda: restart_dispatcher(server, robot))


def _lift(server: "RosbridgeServer", robot: str) -> "SimLift":
    return fleet_at(server, robot).lift


def _door(server: "RosbridgeServer", robot: str) -> "SimDoor":
    return fleet_at(server, robot).doors[0]


def _dispenser(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).offline.add("pharmacy")


def _lanes(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).closed_lanes[:] = CLOSED


FAULTS: Faults = {
    "refuse": ("every request is refused", having(_dispatcher, refuses="out of service")),
    "never": ("requests are neither answered nor carried out", having(_dispatcher, deaf=True)),
    "no-answer": ("requests are carried out and never answered", having(_dispatcher, mute=True)),
    "dispatcher": (f"the dispatcher restarts every {AGAIN:g} s", _restarts),
    "unsourced": ("the bridge lacks the packages rmf_*_msgs", wire.unsourced(*PACKAGES)),
    "fire": ("the lift is in fire mode", having(_lift, mode=FIRE)),
    "door": ("a door is offline", having(_door, is_offline=True)),
    "dispenser": ("the dispenser is offline", _dispenser),
    "lanes": (f"{len(CLOSED)} lanes are closed", _lanes),
    "silent": ("its driver is lost, its fleet adapter goes on", having(robot_of, silence=math.inf)),
    "obstacle": ("permanent obstacle", _stuck),
    "issue": ("its fleet adapter reports an issue", having(robot_of, issues=[ISSUE])),
    "battery": (f"its battery has {FLAT:g} %", having(_body, battery=FLAT)),
    "overloaded": (f"the bridge carries {wire.CARRIED:g} messages/s, the rest queues up", wire.overloaded),
    "dead-rosapi": ("no rosapi", wire.dead_rosapi),
}
