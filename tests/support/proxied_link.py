"""A console's link that goes through a fault proxy, and a stopwatch."""

import os
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from msgspec.structs import replace

from fleet_tui.config.schema import Config
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fault_proxy import FaultProxy, before
from tests.support.invariants import linked
from tests.support.links import ready
from tests.support.polling import HANGS
from tests.support.watched_store import WatchedStore, config_of

PLANTED = ("robot_1", "battery")
"""The alarm that is there before the fault."""

Holds = Callable[[FleetState], object]


def usual(url: str, robots: int) -> Config:
    """A config with the usual limits, or shorter ones unless it is the true ones that are to be measured."""
    config = config_of(url, robots)
    if "FLEET_TUI_FAULTS" in os.environ:
        return config
    return replace(config, alarms=replace(config.alarms, no_answer_after=1.0, not_confirmed_after=1.0))


class Stopwatch:
    """Seconds until a state is as wanted."""

    def __init__(self, store: WatchedStore) -> None:
        self._store, self._began = store, time.monotonic()

    def start(self) -> None:
        self._began = time.monotonic()

    async def until(self, holds: Holds, within: float = HANGS) -> float:
        await self._store.until(holds, within)
        return time.monotonic() - self._began


@asynccontextmanager
async def through(
    server: RosbridgeServer, robots: int = 2
) -> AsyncIterator[tuple[FaultProxy, FleetLink, WatchedStore, Stopwatch]]:
    """A link through a proxy, when all telemetry has come, an alarm is there and a command under way."""
    async with before(server.url) as proxy, linked(config_of(proxy.url, robots)) as (link, store):
        await store.until(ready)
        server.world.robots["robot_1"].battery = 5.0
        server.bridge.services.silent_services.add("/robot_1/Application_layout/Pause")
        link.submit(PauseRobot("robot_1"))
        await store.until(lambda state: state.alarms and server.bridge.services.calls)
        call = server.bridge.services.calls.pop()
        yield proxy, link, store, Stopwatch(store)
        assert call not in server.bridge.services.calls, "it was sent again"


def lost(reason: str = "") -> Holds:
    """Tell whether the link is down for this reason."""
    return lambda state: (
        state.links["rosbridge"].phase is Phase.WAITING and reason in state.links["rosbridge"].reason
    )


def fresh(robots: int = 2) -> Holds:
    """Tell whether the link and its command path are up, and every robot has reported since."""

    def holds(state: FleetState) -> bool:
        link = state.links["rosbridge"]
        spoke = sum((robot.last_received or 0.0) > link.since for robot in state.robots.values())
        return ready(state) and link.phase is Phase.UP and spoke >= robots

    return holds
