"""The simulator as a separate process: serves until it is stopped."""

import asyncio
import os
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import AbstractAsyncContextManager, AsyncExitStack, suppress

from fleet_tui.signals import stop, stopped_by_signal
from fleet_tui.simulator.faults import parse_faults_of
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.kinds import KINDS, play
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.site import SitedBridge, faults_of, site_of

DIALECTS = {"1": ROS1, "2": ROS2}


def run(
    robots: int,
    floors: int,
    port: int,
    rate: float,
    seed: int,
    announce: Callable[[Sequence[str]], None],
    *,
    stop_with_stdin: bool = False,
    faults: str = "",
    first: int = 0,
    speed: float = 1.0,
    ros: str = "",
    kind: str = "oh_ressources",
    beside: AbstractAsyncContextManager[str] | None = None,
) -> None:
    """Serve a simulated site on loopback and announce the URLs of its bridges; returns on SIGTERM.

    `rate`: poses per robot in Hz; port 0: free ones, else that of the first bridge. `stop_with_stdin`: also
    return when stdin closes, as it does when the parent dies. `faults`: as `parse_faults_of` reads them;
    `speed`: seconds of the robots' time in a second; `kind`, `ros`, `first`: as `site_of` has them; `beside`
    is served, too. Raises FleetError, and SystemExit(130) on Ctrl-C."""
    site = site_of(kind, robots, ros, first)
    wanted = parse_faults_of(faults, faults_of(site))
    servers = list[RosbridgeServer]()
    for at, bridge in enumerate(site, port):
        fleets, dialect = _fleets(bridge, floors, seed), DIALECTS[bridge.ros]
        servers.append(RosbridgeServer(fleets, port=port and at, rate=rate, speed=speed, dialect=dialect))
        play(servers[-1], [one for one in wanted if one[1] in servers[-1].bridge.services.robots])
    if asyncio.run(serve_until_stopped(servers, announce, stop_with_stdin, beside)):
        raise SystemExit(130)


def _fleets(bridge: SitedBridge, floors: int, seed: int) -> list[Fleet]:
    return [
        KINDS[crew.kind].build(len(crew.numbers), floors, seed, crew.numbers.start, crew.numbers.step)
        for crew in bridge.crews
    ]


async def serve_until_stopped(
    servers: Sequence[RosbridgeServer],
    announce: Callable[[Sequence[str]], None],
    stop_with_stdin: bool,
    beside: AbstractAsyncContextManager[str] | None,
) -> bool:
    """Serve bridges, and what is `beside` them; return whether Ctrl-C stopped it."""
    stopped = stopped_by_signal()
    async with AsyncExitStack() as stack:
        for server in servers:
            stack.push_async_callback(server.stop)
            await server.start()
        urls = [server.url for server in servers]
        if beside is not None:
            urls.append(await stack.enter_async_context(beside))
        announce(urls)
        if stop_with_stdin:
            threading.Thread(target=_await_stdin, args=(stopped,), daemon=True).start()
        return await stopped


def _await_stdin(stopped: asyncio.Future[bool]) -> None:
    """Wait on a thread of its own until stdin closes, then stop."""
    # os.read, not sys.stdin.read: a daemon thread inside a buffered read aborts the interpreter's exit.
    while os.read(sys.stdin.fileno(), 4096):
        pass
    with suppress(RuntimeError):  # the loop is closed: something else ended it at the same moment
        stopped.get_loop().call_soon_threadsafe(stop, stopped, False)
