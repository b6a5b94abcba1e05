"""Faults of robots with move_base."""

import asyncio
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from fleet_tui.simulator.faults import FAULTS as OF_ALL
from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.faults.plays import Faults, Play, having
from fleet_tui.simulator.navigating.faults import AWHILE, BODY, navigation_of, often

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.move_base.navigation import SimMoveBase
    from fleet_tui.simulator.server import RosbridgeServer

Take = Callable[[dict[str, Any]], None]

CONNECTS = 0.1  # seconds in which `first-lost` connects a new publisher
GENERIC = ("frozen-rosapi", "dead-rosapi", "overloaded")


def _aborts(navigation: "SimMoveBase") -> None:
    navigation.abort()


def _dies(navigation: "SimMoveBase") -> None:
    navigation.die()


def _restarts(server: "RosbridgeServer", robot: str) -> None:
    """Restart the node once, in the middle of its first goal."""
    done = False

    def restart(navigation: "SimMoveBase") -> None:
        nonlocal done
        if not done:
            done = True
            navigation.restart()

    often(restart)(server, robot)


def _intercepted(change: "Callable[[RosbridgeServer, Take, dict[str, Any]], None]", parts: str = "") -> Play:
    """Return a fault in the delivery of goals and cancellations: `change` replaces the function that receives
    the message."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        for name, take in server.bridge.services.subscriptions.items():
            if name.startswith(f"/{robot}/") and name.endswith(parts):
                server.bridge.services.subscriptions[name] = partial(change, server, take)

    return play


def _lost(_server: "RosbridgeServer", _take: Take, _message: dict[str, Any]) -> None:
    """Ignore the message."""


def _late(_server: "RosbridgeServer", take: Take, message: dict[str, Any]) -> None:
    asyncio.get_running_loop().call_later(wire.LATE, take, message)


def _drop(server: "RosbridgeServer", take: Take, message: dict[str, Any]) -> None:
    take(message)
    server.abort_clients()


def _first_lost(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.guests.connects_in = CONNECTS


FAULTS: Faults = {
    **BODY,
    "reject": ("every goal is rejected: status 5", having(navigation_of, rejects=True)),
    "no-plan": ("no path to any goal: recoveries, then an abort", having(navigation_of, plans=False)),
    "aborts": (f"every drive is aborted after {AWHILE:g} s", often(_aborts)),
    "dead-server": (f"move_base crashes {AWHILE:g} s after the first goal", often(_dies)),
    "restart": (f"move_base is restarted {AWHILE:g} s after the first goal: its goals are lost", _restarts),
    "no-feedback": ("no feedback while driving", having(navigation_of, publishes=False)),
    "unlocalised": ("no pose from amcl", wire.without("amcl_pose")),
    "never": ("goals and cancellations are ignored", _intercepted(_lost)),
    "refuse-cancel": ("cancellations are ignored", _intercepted(_lost, "/cancel")),
    "late": (f"goals and cancellations are taken after {wire.LATE:g} s", _intercepted(_late)),
    "drop": ("a goal or cancellation is taken, then all connections drop", _intercepted(_drop)),
    "first-lost": (
        f"what a client publishes is lost for {CONNECTS:g} s after it has advertised the topic",
        _first_lost,
    ),
    "unsourced": ("the bridge lacks the package move_base_msgs", wire.unsourced("move_base_msgs")),
} | {name: OF_ALL[name] for name in GENERIC}
