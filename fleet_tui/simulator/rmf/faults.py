"""Faults of fleets, of their robots, and of the dispatcher."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.simulator.faults import Faults, wire

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.rmf.fleet import RmfFleet
    from fleet_tui.simulator.rmf.member import SimMember
    from fleet_tui.simulator.server import RosbridgeServer

AGAIN = 20.0
"""Seconds after which a dispatcher restarts."""
FLAT = 8.0
FIRE = 3
CLOSED = (2, 5)
"""Per cent."""
PACKAGES = ("rmf_fleet_msgs", "rmf_task_msgs", "rmf_building_map_msgs", "rmf_lift_msgs", "rmf_door_msgs")


def fleet_at(server: "RosbridgeServer", robot: str) -> "RmfFleet":
    from fleet_tui.simulator.rmf.fleet import RmfFleet

    fleet = server.bridge.services.fleet_of(robot)
    assert isinstance(fleet, RmfFleet)
    return fleet


def _member(change: "Callable[[SimMember], None]") -> wire.Play:
    return lambda server, robot: change(fleet_at(server, robot).robots[robot])


def _lost(member: "SimMember") -> None:
    member.silence = math.inf


def _stuck(member: "SimMember") -> None:
    member.body.block()


def _issue(member: "SimMember") -> None:
    member.issues = [{"category": "lift", "detail": "lift_1 does not answer"}]


def _battery(member: "SimMember") -> None:
    member.body.battery = FLAT


def _refuse(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).dispatcher.refuses = "out of service"


def _deaf(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).dispatcher.deaf = True


def _mute(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).dispatcher.mute = True


def restart_dispatcher(server: "RosbridgeServer", robot: str) -> None:
    """Start the dispatcher again: it takes every request once more that a client had latched."""
    from fleet_tui.simulator.rmf.fleet import REQUESTS

    fleet, topic = fleet_at(server, robot), server.bridge.topics.get(REQUESTS)
    fleet.dispatcher.restart()
    if topic is not None and topic.latched and topic.history is not None:
        for payload in topic.history():
            fleet.take(payload.msg)


def _restarts(server: "RosbridgeServer", robot: str) -> None:
    left = AGAIN

    def step(dt: float) -> None:
        nonlocal left
        left -= dt / server.speed
        if left <= 0.0:
            left = AGAIN
            restart_dispatcher(server, robot)

    fleet_at(server, robot).troubles.append(step)


def _fire(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).lift.mode = FIRE


def _door(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).doors[0].is_offline = True


def _dispenser(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).offline.add("pharmacy")


def _lanes(server: "RosbridgeServer", robot: str) -> None:
    fleet_at(server, robot).closed_lanes[:] = CLOSED


def _unsourced(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.unsourced |= set(PACKAGES)


FAULTS: Faults = {
    "refuse": ("every request is refused", _refuse),
    "never": ("requests are neither answered nor carried out", _deaf),
    "no-answer": ("requests are carried out and never answered", _mute),
    "dispatcher": (f"the dispatcher restarts every {AGAIN:g} s", _restarts),
    "unsourced": ("the bridge lacks the packages rmf_*_msgs", _unsourced),
    "fire": ("the lift is in fire mode", _fire),
    "door": ("a door is offline", _door),
    "dispenser": ("the dispenser is offline", _dispenser),
    "lanes": (f"{len(CLOSED)} lanes are closed", _lanes),
    "silent": ("its driver is lost, its fleet adapter goes on", _member(_lost)),
    "obstacle": ("permanent obstacle", _member(_stuck)),
    "issue": ("its fleet adapter reports an issue", _member(_issue)),
    "battery": (f"its battery has {FLAT:g} %", _member(_battery)),
    "overloaded": (f"the bridge carries {wire.CARRIED:g} messages/s, the rest queues up", wire.overloaded),
    "dead-rosapi": ("no rosapi", wire.dead_rosapi),
}
