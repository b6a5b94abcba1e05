"""The simulator as a process of its own: serves until it is told to stop."""

import asyncio
import os
import sys
import threading
from collections.abc import Callable
from contextlib import suppress

from fleet_tui.simulator.faults import parse_faults, play
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.ros.ros1 import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.stopping import stop, stopped_by_signal

DIALECTS = {"1": ROS1, "2": ROS2}


def run(
    robots: int,
    floors: int,
    port: int,
    rate: float,
    seed: int,
    announce: Callable[[str], None],
    stop_with_stdin: bool = False,
    faults: str = "",
    first: int = 0,
    speed: float = 1.0,
    ros: str = "",
    kind: str = "oh_ressources",
) -> None:
    """Serve a simulated fleet on loopback and announce its ws:// URL; returns on SIGTERM.

    `rate`: poses per robot in Hz; port 0: a free one. `stop_with_stdin`: also return when stdin closes,
    so that the death of the parent, however sudden, is the end of this process too. `faults`: what goes
    wrong, as `parse_faults` reads it; `first`: the number in the first robot's name; `speed`: seconds of
    the robots' time in a second; `ros`: the generation of ROS, `1` or `2`, or empty: the one that is usual
    for the `kind`. Raises ConfigError for a fault that is none, FleetError where the port can't be had,
    SystemExit(130) on Ctrl-C.
    """
    fleet = KINDS[kind].build(robots, floors, seed, first)
    dialect = DIALECTS[ros or KINDS[kind].ros[0]]
    server = RosbridgeServer(fleet, port=port, rate=rate, speed=speed, dialect=dialect)
    play(server, parse_faults(faults, fleet.robots, fleet.faults))
    if asyncio.run(_serve(server, announce, stop_with_stdin)):
        raise SystemExit(130)


async def _serve(server: RosbridgeServer, announce: Callable[[str], None], stop_with_stdin: bool) -> bool:
    """Serve until something ends it, and say whether that was Ctrl-C."""
    stopped = stopped_by_signal()
    await server.start()
    try:
        announce(server.url)
        if stop_with_stdin:
            threading.Thread(target=_await_stdin, args=(stopped,), daemon=True).start()
        return await stopped
    finally:
        await server.stop()


def _await_stdin(stopped: asyncio.Future[bool]) -> None:
    # os.read, not sys.stdin.read: a daemon thread inside a buffered read aborts the interpreter's exit.
    while os.read(sys.stdin.fileno(), 4096):
        pass
    with suppress(RuntimeError):  # the loop is closed: something else ended it at the same moment
        stopped.get_loop().call_soon_threadsafe(stop, stopped, False)
